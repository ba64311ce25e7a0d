"""Maps beside the truth."""

import numpy as np
import pytest

from coursekit.nav.map_compare import compare, outline_points
from coursekit.nav.map_file import GridMap

ROOM = np.array([[0.5, 0.5, 3.5, 0.5], [3.5, 0.5, 3.5, 2.5], [3.5, 2.5, 0.5, 2.5], [0.5, 2.5, 0.5, 0.5]])


def drawn(shift=0.0, thick=1):
    """A room of 3 m x 2 m as a map, 5 cm cells, its walls moved and made thicker, outwards."""
    cells = np.full((60, 80), -1, dtype=np.int8)
    k = round(shift / 0.05)
    cells[10 : 50 + k, 10 + k : 70 + k] = 0
    low, high, grow = 10 + k, slice(49 + k, 49 + k + thick), slice(11 + k - thick, 11 + k)
    for rows, columns in ((grow, slice(low, 70 + k)), (high, slice(low, 70 + k))):
        cells[rows, columns] = 100
    for columns in (grow, slice(69 + k, 69 + k + thick)):
        cells[low : 50 + k, columns] = 100
    return GridMap(cells, 0.05, (0.0, 0.0, 0.0))


def test_a_right_map_is_right():
    told = compare(drawn(), outline_points(ROOM))
    assert told.iou > 0.99 and told.false == 0 and told.missed < 0.01 and told.distance < 0.05


@pytest.mark.parametrize("shift", [0.15, 0.3])
def test_walls_in_the_wrong_place_are_false_and_missed(shift):
    told = compare(drawn(shift), outline_points(ROOM))
    assert told.iou < 0.3 and told.false > 0.5 and told.distance == pytest.approx(shift, abs=0.06)


def test_thick_walls_are_seen():
    assert compare(drawn(thick=3), outline_points(ROOM)).thickness > 2 * compare(drawn(), outline_points(ROOM)).thickness


def test_what_the_map_cannot_know_does_not_count():
    next_door = np.array([[5.0, 5.0, 9.0, 5.0]])
    alone, more = (compare(drawn(), outline_points(edges)) for edges in (ROOM, np.concatenate([ROOM, next_door])))
    assert alone == more


def test_a_map_may_be_turned():
    told = compare(drawn(), outline_points(ROOM))
    grid = GridMap(drawn().cells, 0.05, (1.0, 2.0, 0.5))
    c, s = np.cos(0.5), np.sin(0.5)
    turned = outline_points(ROOM) @ np.array([[c, s], [-s, c]]) + (1.0, 2.0)
    assert compare(grid, turned).iou == pytest.approx(told.iou, abs=0.02)


def test_circles_are_outlines_too():
    points = outline_points(np.zeros((0, 4)), np.array([[1.0, 2.0, 0.5]]))
    assert np.hypot(*(points - (1.0, 2.0)).T) == pytest.approx(np.full(len(points), 0.5))


def test_nothing_to_compare_is_said():
    empty = GridMap(np.zeros((5, 5), dtype=np.int8), 0.05, (0.0, 0.0, 0.0))
    with pytest.raises(ValueError, match="no walls"):
        compare(empty, outline_points(ROOM))
    with pytest.raises(ValueError, match="in one frame"):
        compare(drawn(), outline_points(ROOM) + 100)
