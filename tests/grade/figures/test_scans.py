"""Rays that were cast and scans that were matched: right ones, and where a wrong one ends."""

import math

import pytest

from .seen import handed_out, labels


def cast(walls, x, y, angle, range_max=10.0, *, behind=False, nearest=True):
    c, s, distances = math.cos(angle), math.sin(angle), []
    for x1, y1, x2, y2 in walls:
        across = c * (y2 - y1) - s * (x2 - x1)
        if abs(across) > 1e-12:
            t = ((x1 - x) * (y2 - y1) - (y1 - y) * (x2 - x1)) / across
            part = ((x1 - x) * s - (y1 - y) * c) / across
            distances += [t] if (behind or t >= 0) and t <= range_max and 0 <= part <= 1 else []
    return (min if nearest else max)(distances, default=math.inf)


def test_right_rays_are_drawn_in_the_room():
    figure, passed = handed_out("ch08.q2", cast_ray=cast)
    assert passed and {"a wall", "a ray, up to the first wall"} <= labels(figure) and not figure.panels[0].rings


@pytest.mark.parametrize(
    ("wrong", "end", "alt"),
    [
        ({"behind": True}, (2.0, 0.0), "it goes on without meeting a wall; your answer goes -2.00 m"),
        ({"nearest": False}, (3.0, 0.0), "it goes 1.00 m; your answer goes 3.00 m"),
    ],
)
def test_a_wrong_ray_is_drawn_beside_the_right_one_and_its_end_is_marked(wrong, end, alt):
    figure, passed = handed_out("ch08.q2", cast_ray=lambda *given: cast(*given, **wrong))
    assert not passed and {"the ray", "your answer"} <= labels(figure) and alt in figure.alt
    assert figure.panels[0].rings == [pytest.approx(end)]


def test_a_scan_that_stays_at_the_guess_is_marked_and_both_gaps_are_said():
    figure, passed = handed_out("ch08.q3", match=lambda points, gap, guess: guess)
    assert not passed and [panel.title for panel in figure.panels] == ["before: at the guess", "after matching"]
    assert {"the scan at the guess", "where you put the scan"} <= labels(figure)
    before, after = figure.panels
    assert before.shapes[1].points == after.shapes[1].points and before.view == after.view


def test_a_pose_anywhere_is_drawn_within_the_room():
    figure, _ = handed_out("ch08.q3", match=lambda points, gap, guess: (1e300, 0.0, 0.0))
    assert "more than 10 m after matching" in figure.alt
    assert figure.panels[0].view == figure.panels[1].view
