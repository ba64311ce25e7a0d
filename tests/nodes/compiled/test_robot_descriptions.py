"""Compiled programs: urdf's model of a robot."""

from __future__ import annotations

import pytest

from coursekit.processes.executables import make_process
from tests.nodes.compiled.conftest import program

ROBOT = """<robot name="arm">
  <material name="blue"><color rgba="0 0 0.8 1"/></material>
  <link name="base">
    <inertial><origin xyz="0 0 0.1"/><mass value="2.5"/><inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="3"/></inertial>
    <visual><geometry><box size="1 2 3"/></geometry><material name="blue"/></visual>
    <collision><origin xyz="1 0 0"/><geometry><cylinder radius="0.5" length="2"/></geometry></collision>
  </link>
  <link name="upper">
    <visual><geometry><sphere radius="0.25"/></geometry></visual>
    <visual name="skin">
      <geometry><mesh filename="package://arm/skin.stl" scale="2 2 2"/></geometry><material name="blue"/>
    </visual>
  </link>
  <link name="tip"/>
  <link name="follower"/>
  <joint name="shoulder" type="revolute">
    <parent link="base"/><child link="upper"/><origin xyz="0 0 1" rpy="0 0 1.5707963"/><axis xyz="0 0 2"/>
    <limit lower="-1" upper="2" effort="10" velocity="3"/><dynamics damping="0.5"/>
    <safety_controller k_velocity="7" k_position="6" soft_lower_limit="-0.5" soft_upper_limit="1.5"/>
  </joint>
  <joint name="fixed" type="fixed"><parent link="upper"/><child link="tip"/></joint>
  <joint name="copy" type="continuous">
    <parent link="base"/><child link="follower"/><axis xyz="1 0 0"/><mimic joint="shoulder" multiplier="-2" offset="0.5"/>
  </joint>
</robot>"""


@pytest.fixture
def said(session, build, tmp_path):
    """What the program prints of a robot, by its way of reading."""

    def run(how, text):
        (tmp_path / "robot.urdf").write_text(text, encoding="utf-8")
        path = build("robots", program("robots.cpp"))
        process = session.launch(make_process(session, path, [how, "robot.urdf"], name="robots", cwd=str(tmp_path)))
        assert process.wait(20.0) == 0, process.output
        return process.output.splitlines()

    return run


@pytest.mark.parametrize("how", ["string", "file"])
def test_a_robot_has_the_parts_that_its_description_tells(said, how):
    assert said(how, ROBOT) == [
        "arm 4 links 3 joints 1 materials, root base",
        "base: child joints copy shoulder, child links follower upper, no parent",
        "inertial 2.5 0.1 1 2 3",
        "box 1 2 3, blue 0.8, one object",
        "cylinder 0.5 2 at 1",
        "upper: 2 visuals, sphere 0.25, skin package://arm/skin.stl 2, parent base by shoulder",
        "shoulder revolute 1 rpy 0 0 1.57, axis 0 0 1",
        "limits -1 2 10 3, damping 0.5, safety -0.5 1.5 6 7",
        "fixed fixed, axis 0, no limits, no dynamics",
        "copy mimics shoulder -2 0.5",
        "no such link, no such joint",
        "1 2 0",
    ]


def test_what_is_wrong_with_a_description_is_said(said):
    lines = said("string", "<robot name='r'><link name='a'/><link name='b'/></robot>")
    assert {"no robot", "Failed to parse robot description using: urdf_xml_parser/URDFXMLParser"} <= set(lines)
    assert any(line.startswith("Error:   ") and "root link" in line for line in lines)


def test_a_file_that_is_not_there_is_no_robot(said):
    assert sorted(said("nowhere", ROBOT)) == ["Could not open file [nowhere] for parsing.", "no robot"]
