"""Robots of chapter 7, a round of chapter 9, turtles, an arm, photographs: what happened, and what should have."""

import colorsys
import math
from pathlib import Path

import pytest
from ament_index_python.packages import get_package_share_directory

from coursekit.grade.chapters.ch09 import STOPS, _course_map
from coursekit.grade.figures.drives import driven
from coursekit.grade.figures.robots import four_robots, seen_by_me, table, worked
from coursekit.grade.figures.turtles import PAPER, walked
from coursekit.urdf import load
from coursekit.view.figure import Arrow, Line, Mover, view_of
from coursekit.view.figure_style import COLOURS

from .seen import count, handed_out, labels


def arrows(figure):
    return {shape.label: (shape.x, shape.y, shape.heading) for shape in figure.panels[0].shapes if isinstance(shape, Arrow)}


def test_a_right_view_puts_the_other_where_it_is():
    arrow_by_label = arrows(seen_by_me((1.0, 1.0, math.pi / 2), (1.0, 3.0, 0.0), (2.0, 0.0, -math.pi / 2)))
    assert set(arrow_by_label) == {"me", "the other"}


def test_a_wrong_view_is_drawn_where_it_puts_the_other():
    figure = seen_by_me((1.0, 1.0, math.pi / 2), (1.0, 3.0, 0.0), (0.0, 2.0, 0.0))
    assert arrows(figure)["where your answer puts it"] == pytest.approx((-1.0, 1.0, math.pi / 2))
    assert "2.83 m beside it" in figure.alt


def test_an_answer_that_is_nowhere_near_leaves_the_picture_as_large_as_it_is():
    left, right, low, high = view_of(seen_by_me((0.0, 0.0, 0.0), (1.0, 1.0, 0.0), (1e9, 0.0, 0.0)).panels[0])
    assert right - left < 10 and high - low < 10


def test_a_robot_s_track_is_parted_where_it_takes_and_leaves_a_load():
    stages = [(6, 0.0), (0, 0.0), (1, 0.0), (1, 1.0), (2, 1.0), (3, 1.0), (4, 1.0), (4, 2.0), (5, 2.0), (6, 2.0), (0, 2.0)]
    told = [(stage, (x, 0.0, 0.0)) for stage, x in stages]
    figure = worked(told, [(1.0, 0.0, 0.0)] * 3, [(2.0, 0.0, 0.0)] * 3)
    ways = {shape.label: shape.points for shape in figure.panels[0].shapes if isinstance(shape, Line)}
    assert ways == {"to a load": [(0.0, 0.0), (1.0, 0.0)], "with a load": [(1.0, 0.0), (2.0, 0.0)]}
    assert "2 loads begun" in figure.alt and {"a pickup", "a delivery", "its start"} <= labels(figure)


def test_the_table_has_a_strip_for_each_robot_and_what_it_reports():
    figure = table({1: [8] * 3 + [4] * 7, 2: [8] * 10, 3: [8, 7], 4: [0] * 10}, {1: [0.1, 0.2]})
    assert count(figure, "unknown") == 3 + 10 + 1 and count(figure, "guess") == 1 and count(figure, "cost3") == 17
    assert "it reports" in labels(figure)


def test_four_robots_have_four_tracks_and_move():
    figure = four_robots([[(0.01 * k, float(n), 0.0) for k in range(100)] for n in range(4)])
    assert {f"robot{n}" for n in range(1, 5)} <= labels(figure) and "robot1 1.0 m" in figure.alt
    assert sum(isinstance(shape, Mover) for shape in figure.panels[0].shapes) == 4


def plan(*places):
    return {"poses": [{"pose": {"position": {"x": x, "y": y}}} for x, y in places]}


def test_a_round_is_drawn_with_its_stops_and_the_first_plan_to_each():
    plans = [plan((0, 0), STOPS[0]), plan((0.5, 0), STOPS[0]), plan(STOPS[0], STOPS[1]), {"poses": []}]
    poses = [{"pose": {"pose": {"position": {"x": x, "y": 0.1}}}} for x in (0.0, 1.2)]
    figure = driven(_course_map(), [(0.0, 0.0), (1.2, 0.0)], poses, plans, STOPS)
    assert sum(getattr(shape, "label", "") == "planned" for shape in figure.panels[0].shapes) == 2
    assert {"driven, as amcl finds", "by odometry alone", "a stop", "her start"} <= labels(figure) and "1.2 m" in figure.alt


def test_a_round_without_a_track_shows_its_stops():
    assert "a stop" in labels(driven(_course_map(), [], [], [], STOPS))


def test_a_turtle_s_line_lies_on_its_paper():
    figure = walked([(5.5, 5.5, 0.0), (7.5, 5.5, 0.0)], (9.0, PAPER, 9.0, PAPER))
    assert view_of(figure.panels[0]) == (0.0, PAPER, 0.0, PAPER) and "2.0 m long" in figure.alt
    assert {"its line", "its start", "its end", "where it is to end"} == labels(figure)


def test_an_arm_s_wrong_tip_is_marked_beside_the_right_one():
    figure, passed = handed_out("ch06.q2", tip=lambda *given: (0.1, 0.2))
    assert not passed and {"upper arm", "forearm", "tip", "your answer"} <= labels(figure)
    assert figure.panels[0].rings == [(0.1, 0.2)]


def views_of(*sides):
    """A photograph of each of these sides of an outline, counted from 0."""
    from geometry_msgs.msg import Pose, PoseArray

    def views(outline):
        poses, corners = PoseArray(header=outline.header), [(point.x, point.y) for point in outline.polygon.points]
        for side in sides:
            (x, y), (to_x, to_y) = corners[side], corners[(side + 1) % len(corners)]
            along = math.hypot(to_x - x, to_y - y)
            pose, yaw = Pose(), math.atan2(to_x - x, y - to_y)
            pose.position.x = (x + to_x) / 2 + 1.6 * (to_y - y) / along
            pose.position.y = (y + to_y) / 2 - 1.6 * (to_x - x) / along
            pose.orientation.z, pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
            poses.poses.append(pose)
        return poses

    return views


def test_a_side_that_no_photograph_shows_is_marked_in_its_middle():
    figure, passed = handed_out("appb.q4", views=views_of(0, 1, 2))
    assert not passed and figure.panels[0].rings == [(0.6, 0.0)]
    assert {"the outline", "what it sees", "a photograph"} == labels(figure)


def _hue(red, green, blue):
    return 360 * colorsys.rgb_to_hsv(red, green, blue)[0]


@pytest.mark.parametrize("number", range(1, 5))
def test_a_track_has_the_colour_of_its_robot_in_the_viewer(number):
    robot = load(Path(get_package_share_directory("coursekit_robots")) / f"urdf/robot{number}.urdf")
    materials = [part.material for link in robot.links.values() for part in link.visuals if part.material]
    body = _hue(*next(material.colour for material in materials if material.name == "shell")[:3])
    for shade in COLOURS[f"robot{number}"]:
        drawn = _hue(*(int(shade[at : at + 2], 16) / 255 for at in (1, 3, 5)))
        assert abs(math.remainder(drawn - body, 360)) < 25
