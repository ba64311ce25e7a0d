"""Frames from joint positions: the same for a list of names that is known and for one that is new."""

import math

import pytest

from coursekit.nodes.robots.joint_frames import JointFrames
from coursekit.urdf import parse

URDF = """<robot name="arm">
  <link name="base"/><link name="a"/><link name="b"/><link name="c"/><link name="plate"/>
  <joint name="shoulder" type="revolute"><parent link="base"/><child link="a"/><axis xyz="0 0 1"/>
    <limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
  <joint name="elbow" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
    <mimic joint="shoulder" multiplier="2" offset="0.5"/></joint>
  <joint name="finger" type="prismatic"><parent link="b"/><child link="c"/><axis xyz="1 0 0"/>
    <limit lower="0" upper="9" effort="1" velocity="1"/><mimic joint="elbow" multiplier="0.1"/></joint>
  <joint name="weld" type="fixed"><parent link="base"/><child link="plate"/><origin xyz="0 0 1"/></joint>
</robot>"""


@pytest.fixture
def frames():
    return JointFrames(parse(URDF), "")


def angle(msg):
    return 2 * math.atan2(msg.transform.rotation.z, msg.transform.rotation.w)


def told(frames, names, positions):
    return {msg.child_frame_id: msg for msg in frames.moving(names, positions, 1_500_000_000)}


def test_a_joint_that_mimics_follows_also_over_two_joints(frames):
    for position in (0.2, -0.4, 0.2):
        transform_by_frame = told(frames, ["shoulder"], [position])
        assert angle(transform_by_frame["a"]) == pytest.approx(position)
        assert angle(transform_by_frame["b"]) == pytest.approx(2 * position + 0.5)
        assert transform_by_frame["c"].transform.translation.x == pytest.approx(0.1 * (2 * position + 0.5))
        assert (transform_by_frame["a"].header.stamp.sec, transform_by_frame["a"].header.stamp.nanosec) == (1, 500_000_000)


def test_a_position_that_is_told_is_not_mimicked(frames):
    assert angle(told(frames, ["elbow", "shoulder"], [0.3, 0.2])["b"]) == pytest.approx(0.3)


def test_the_last_of_equal_names_counts_and_unknown_ones_do_not(frames):
    transform_by_frame = told(frames, ["shoulder", "nose", "shoulder"], [0.1, 9.0, 0.2])
    assert angle(transform_by_frame["a"]) == pytest.approx(0.2) and len(transform_by_frame) == 3
    assert told(frames, ["nose"], [1.0]) == {}


def test_another_prefix_counts_from_the_next_message_on(frames):
    assert set(told(frames, ["elbow"], [0.0])) == {"b", "c"}
    frames.prefix = "left/"
    transform_by_frame = told(frames, ["elbow"], [0.0])
    assert set(transform_by_frame) == {"left/b", "left/c"} and transform_by_frame["left/b"].header.frame_id == "left/a"
    assert [(msg.child_frame_id, msg.transform.translation.z) for msg in frames.fixed(0)] == [("left/plate", 1.0)]
