"""What turtles draw on."""

import itertools
import math

import pytest

from coursekit.sim.paper import Paper

RED, BLUE = (255, 0, 0), (0, 0, 255)


def circle(steps, radius=1.0):
    return [
        (2 + radius * math.cos(2 * math.pi * i / steps), 2 + radius * math.sin(2 * math.pi * i / steps))
        for i in range(steps + 1)
    ]


def draw(paper, points, colour=RED, by="turtle1", width=3):
    for start, end in itertools.pairwise(points):
        paper.line(by, start, end, colour, width)


def test_a_straight_drive_is_one_stroke_of_two_points():
    paper = Paper(4.0)
    draw(paper, [(0.01 * i, 1.0) for i in range(200)])
    assert [stroke.points for stroke in paper.strokes] == [[(0.0, 1.0), pytest.approx((1.99, 1.0))]]


def test_a_circle_keeps_its_shape_with_few_points():
    paper = Paper(4.0)
    draw(paper, circle(400))
    (stroke,) = paper.strokes
    assert len(stroke.points) < 200
    assert all(math.dist(point, (2, 2)) == pytest.approx(1.0) for point in stroke.points)
    middles = [((a[0] + b[0]) / 2, (a[1] + b[1]) / 2) for a, b in zip(stroke.points, stroke.points[1:], strict=False)]
    assert all(math.dist(middle, (2, 2)) > 0.998 for middle in middles)


def test_a_corner_stays_where_it_is():
    paper = Paper(4.0)
    draw(paper, [(1.0, 1.0), (1.01, 1.0), (1.02, 1.0), (1.02, 1.01), (1.02, 1.02)])
    assert paper.strokes[0].points == [(1.0, 1.0), (1.02, 1.0), (1.02, 1.02)]


def test_another_colour_another_turtle_or_a_jump_begins_a_stroke():
    paper = Paper(4.0)
    draw(paper, [(0, 0), (1, 0)])
    draw(paper, [(1, 0), (2, 0)], BLUE)
    draw(paper, [(3, 0), (3, 1)], BLUE)
    draw(paper, [(3, 1), (3, 2)], BLUE, by="turtle2")
    assert len(paper.strokes) == 4


def test_the_colour_sensor_sees_the_topmost_line():
    paper = Paper(4.0)
    draw(paper, [(0, 2), (4, 2)])
    draw(paper, [(2, 0), (2, 4)], BLUE)
    assert paper.colour_at(1, 2) == RED
    assert paper.colour_at(2, 2) == BLUE
    assert paper.colour_at(1, 3) == (255, 255, 255)


def test_points_beyond_the_edge_see_the_edge():
    paper = Paper(4.0)
    draw(paper, [(0, 4), (4, 4)])
    assert paper.colour_at(2, 100) == RED


def test_clear_gives_new_paper():
    paper = Paper(4.0)
    draw(paper, [(0, 2), (4, 2)])
    paper.clear()
    assert paper.strokes == [] and paper.edition == 1 and paper.colour_at(1, 2) == (255, 255, 255)
