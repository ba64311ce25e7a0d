"""What the checks of chapter 9 say is wrong with a cost, a line and a way."""

import math

import pytest

from coursekit.grade.chapters import ch09
from coursekit.grade.checking import judge
from coursekit.grade.exercise import find
from tests.grade.tried import told_of


def cost(distance, inscribed=0.2, scaling=3.0, radius=0.55, start=None):
    if distance <= inscribed:
        return 253 if distance > 0 else 254
    start = inscribed if start is None else start
    return int(252 * math.exp(-scaling * (distance - start))) if distance <= radius else 0


def test_the_costs_themselves_are_taken(tmp_path):
    assert judge(find("ch09.q1"), {"inflation_cost": cost}, tmp_path).passed


@pytest.mark.parametrize(
    ("wrong", "cause"),
    [
        (lambda d, i=0.2, s=3.0, r=0.55: cost(d, i, s, r, start=0.0), "begins to fall at `inscribed`"),
        (lambda d, i=0.2, s=3.0, r=0.55: cost(d, i, 3.0, r), "`scaling` used"),
        (lambda d, i=0.2, s=3.0, r=0.55: cost(d, i, s, 0.55), "`radius` used"),
        (lambda *given: float(cost(*given)), "`int(...)` makes an integer"),
        (lambda d, i=0.2, s=3.0, r=0.55: round(252 * math.exp(-s * (d - i))) if i < d <= r else cost(d, i, s, r), "Cut off"),
    ],
)
def test_a_cost_s_fault_is_named(tmp_path, wrong, cause):
    assert cause in told_of("ch09.q1", {"inflation_cost": wrong}, tmp_path).cause


@pytest.mark.parametrize(
    ("output", "cause"),
    [
        ("[INFO] [1.0] [basic_navigator]: stop 1: SUCCEEDED\n", "`print`"),
        ("stop 1: TaskResult.SUCCEEDED\n", "`getResult().name`"),
        ("stop 1: FAILED\n", ""),
    ],
)
def test_lines_that_are_not_as_asked_for_are_told_why(output, cause):
    assert cause in ch09._why_lines(output) and bool(cause) == bool(ch09._why_lines(output))


def test_a_price_is_no_way(tmp_path):
    assert "One number came" in told_of("ch09.q2", {"find_path": lambda *_: 13.0}, tmp_path).cause


def line(costs, start, goal):
    """A path that goes along one axis, then along the other."""
    (r, c), cells = start, [start]
    while r != goal[0]:
        r += 1 if goal[0] > r else -1
        cells.append((r, c))
    while c != goal[1]:
        c += 1 if goal[1] > c else -1
        cells.append((r, c))
    return cells


@pytest.mark.parametrize(
    ("find_path", "cause"),
    [
        (lambda *given: line(*given)[::-1], "the wrong way round"),
        (lambda *given: line(*given)[1:], "Both ends belong to it"),
        (lambda *given: (line(*given), 13.0), "The path alone"),
        (lambda costs, start, goal: [] if costs.max() == 253 else line(costs, start, goal), "An empty list is not None"),
    ],
)
def test_a_path_s_fault_is_named(tmp_path, find_path, cause):
    assert cause in told_of("ch09.q2", {"find_path": find_path}, tmp_path).cause


def test_a_number_in_numpy_s_form_is_a_number(tmp_path):
    import numpy as np

    assert judge(find("ch09.q1"), {"inflation_cost": lambda *given: np.array(cost(*given))}, tmp_path).passed


def test_a_text_is_told_to_be_none(tmp_path):
    assert "leave the quotes" in told_of("ch09.q1", {"inflation_cost": lambda *given: str(cost(*given))}, tmp_path).cause
