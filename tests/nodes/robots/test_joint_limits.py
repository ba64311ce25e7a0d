"""What joint_state_publisher asks of a description: limits of every joint that has an end, in numbers."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
import rclpy

from coursekit.nodes.robots.joint_model import Options, read
from coursekit.urdf import UrdfError

OPTIONS = Options({}, {})
LINKS = '<link name="a"/><link name="b"/>'
JOINT = '<joint name="j" type="{kind}"><parent link="a"/><child link="b"/>{limit}</joint>'
URDF = f'<robot name="r">{LINKS}{JOINT}</robot>'
SDF = '<sdf version="1.8"><model name="m"><joint name="j" type="{kind}"><axis>{limit}</axis></joint></model></sdf>'
COLLADA = """<COLLADA version="1.5.0"><kinematics_model><technique_common>
<joint name="j"><revolute>{limit}</revolute></joint></technique_common></kinematics_model></COLLADA>"""
WRONG = [
    (URDF, "", 'Limits must be specified for joint "j" of type "revolute"'),
    (URDF, '<limit effort="1" velocity="1" upper="1"/>', '"lower" limit must be specified for joint "j" of type "revolute"'),
    (URDF, '<limit effort="1" velocity="1" lower="1"/>', '"upper" limit must be specified for joint "j" of type "revolute"'),
    (
        URDF,
        '<limit effort="1" velocity="1" lower="x" upper="1"/>',
        '"lower" limit must be a float for joint "j" of type "revolute"',
    ),
    (SDF, "", 'Limits must be specified for joint "j" of type "revolute"'),
    (SDF, "<limit><upper>1</upper></limit>", '"lower" limit must be specified for joint "j" of type "revolute"'),
    (SDF, "<limit><lower>1</lower><upper/></limit>", '"upper" limit must be a float for joint "j" of type "revolute"'),
    (COLLADA, "", 'Limits must be specified for joint "j" of type "revolute"'),
    (COLLADA, "<limits><max>1</max></limits>", '"min" limit must be specified for joint "j" of type "revolute"'),
]
NOT_ONE = [
    (f"<urdf>{LINKS}</urdf>", 'URDF must have a "robot" tag'),
    ('<sdf version="1.8"><joint name="j" type="fixed"/></sdf>', 'SDF must have a "model" tag'),
    ("<COLLADA/>", "COLLADA must have a version tag"),
    ('<COLLADA version="1.4.1"/>', "COLLADA must be at least version 1.5.0"),
    ('<COLLADA version="1.5.0"/>', 'COLLADA must have a "kinematics_model" tag'),
    ('<COLLADA version="1.5.0"><kinematics_model/></COLLADA>', 'COLLADA must have a "technique_common" tag'),
]


@pytest.mark.parametrize("text, limit, said", WRONG)
def test_a_joint_with_an_end_needs_both_limits(text, limit, said):
    with pytest.raises(UrdfError) as error:
        read(text.format(kind="revolute", limit=limit), OPTIONS)
    assert error.value.what == said


@pytest.mark.parametrize("text, said", NOT_ONE)
def test_what_holds_no_joints_at_all_is_told(text, said):
    with pytest.raises(UrdfError) as error:
        read(text, OPTIONS)
    assert error.value.what == said


@pytest.mark.parametrize("kind", ["continuous", "fixed", "floating", "planar"])
def test_other_joints_need_none(kind):
    assert list(read(URDF.format(kind=kind, limit=""), OPTIONS).free) == ["j"] * (kind == "continuous")


def test_a_robot_may_stand_inside_another_element():
    limit = '<limit effort="1" velocity="1" lower="-1" upper="2"/>'
    joint = read(f"<urdf>{URDF.format(kind='revolute', limit=limit)}</urdf>", OPTIONS).free["j"]
    assert (joint.least, joint.greatest) == (-1.0, 2.0)


def test_sdf_writes_no_end_as_infinity():
    text = SDF.format(kind="revolute", limit="<limit><lower>-inf</lower><upper>inf</upper></limit>")
    joint = read(text, OPTIONS).free["j"]
    assert (joint.least, joint.greatest) == (-math.pi, math.pi)


def test_who_makes_the_node_hears_the_fault_alone(session, tmp_path: Path):
    from joint_state_publisher.joint_state_publisher import JointStatePublisher

    file = tmp_path / "arm.urdf"
    file.write_text(URDF.format(kind="revolute", limit=""))
    rclpy.init()
    with pytest.raises(ValueError) as error:
        JointStatePublisher(file)
    assert str(error.value) == 'Limits must be specified for joint "j" of type "revolute"'
    rclpy.shutdown()
