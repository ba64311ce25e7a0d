"""A robot's body from its sides, and what it stands on; places in pictures."""

import gc
import math

import numpy as np
import pytest
import trimesh

from coursekit.grade.chapters.measures.body import centre_of_mass, contacts, outside
from coursekit.grade.checking import judge
from coursekit.grade.exercise import find
from coursekit.grade.figures.bodies import _hull, sides, standing
from coursekit.grade.figures.sightings import seen_at
from coursekit.grade.illustration import Illustration
from coursekit.urdf import parse
from coursekit.view.figure import Dots, Line
from coursekit.view.figure_html import html

from .seen import labels

BOX = '<{0}><geometry><box size="{1}"/></geometry></{0}>'
INERTIAL = """<inertial><origin xyz="{} 0 0"/><mass value="1"/>
<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>"""


def robot(mass_at=0.0, height=0.1, x="0"):
    """A box of 0.4 x 0.2 m that stands on the floor, and where its mass is."""
    body = "".join(BOX.format(part, "0.4 0.2 0.2") for part in ("visual", "collision")) + INERTIAL.format(mass_at)
    joint = f'<joint name="j" type="fixed"><origin xyz="{x} 0 {height}"/>'
    joint += '<parent link="floor_link"/><child link="body"/></joint>'
    return parse(f'<robot name="box"><link name="floor_link"/><link name="body">{body}</link>{joint}</robot>')


def line(panel, label):
    return next(shape.points for shape in panel.shapes if isinstance(shape, Line) and shape.label == label)


def test_a_box_is_a_rectangle_from_each_side():
    side, front = sides(robot()).panels
    assert sorted(set(line(side, "body"))) == [(-0.2, 0.0), (-0.2, 0.2), (0.2, 0.0), (0.2, 0.2)]
    assert sorted(set(line(front, "body"))) == [(-0.1, 0.0), (-0.1, 0.2), (0.1, 0.0), (0.1, 0.2)]
    assert {"the floor", "body", "a link's frame"} <= labels(sides(robot()))


@pytest.mark.parametrize("mass_at", [0.0, 0.35])
def test_what_falls_over_has_its_mass_beside_its_contacts(mass_at):
    fallen = robot(mass_at)
    x, y, _ = centre_of_mass(fallen, {}).tolist()
    above = standing(fallen, {}, contacts(fallen, {}), (x, y)).panels[1]
    feet = line(above, "its contacts")
    assert (max(point[0] for point in feet) < x) == (outside(fallen, {}) > 0) == (mass_at > 0.2)
    assert above.shapes[-1] == Dots([(x, y)], "bad", "centre of mass", 5.0)


def test_a_hull_goes_around_all_points_and_leaves_out_what_is_none():
    points = np.array([(0, 0), (1, 0), (1, 1), (0, 1), (0.5, 0.5), (math.nan, 2), (math.inf, 0)])
    assert _hull(points) == [(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)]
    assert _hull(points[:2]) == [(0, 0), (1, 0)] and _hull(points[5:]) == []


@pytest.mark.parametrize("x", ["1e308", "-1e300", "1e7"])
def test_a_link_that_is_nowhere_is_left_out(x):
    markup = html(sides(robot(x=x)))
    assert "nan" not in markup and "<svg" in markup


def test_a_robot_without_a_body_has_its_frames():
    bare = parse('<robot name="bare"><link name="only"/></robot>')
    assert "a link's frame" in labels(sides(bare)) and "<svg" in html(sides(bare))


def test_meshes_are_drawn_when_the_judge_has_gone(tmp_path):
    file = tmp_path / "src" / "s6_py_urdf" / "urdf" / "cart.urdf"
    file.parent.mkdir(parents=True)
    trimesh.creation.box((0.4, 0.2, 0.2)).export(file.with_name("body.stl"))
    shape = f'<visual><geometry><mesh filename="file://{file.with_name("body.stl")}"/></geometry></visual>'
    file.write_text(f'<robot name="cart"><link name="body">{shape}</link></robot>')
    illustration = Illustration()
    judge(find("ch06.q1"), {}, tmp_path, illustration=illustration)
    gc.collect()
    assert (-0.2, -0.1) in line(illustration.figure().panels[0], "body")


def test_a_place_far_from_the_ball_is_joined_with_it():
    figure = seen_at({1: (10.0, 20.0), 2: (50.0, 60.0)}, {1: (11.0, 20.0), 2: (90.0, 60.0), 9: (0.0, 0.0)}, (320, 240), 12.8)
    assert line(figure.panels[0], "how far off") == ((50.0, 60.0), (90.0, 60.0))
    assert "2 answers, 1 far off" in figure.alt and {"the ball", "your place", "a place beside it"} <= labels(figure)
