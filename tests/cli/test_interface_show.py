"""`ros2 interface show` prints what the official pages print: Humble's lines, with comments in words of coursekit's own."""

import re

import pytest

from coursekit.cli.interface_text import shown

PRINTED = {
    "geometry_msgs/msg/Twist": [
        "#", "", "Vector3  linear", "\tfloat64 x", "\tfloat64 y", "\tfloat64 z",
        "Vector3  angular", "\tfloat64 x", "\tfloat64 y", "\tfloat64 z",
    ],
    "std_msgs/msg/String": ["#", "", "string data"],
    "std_srvs/srv/Empty": ["---"],
    "std_srvs/srv/SetBool": ["bool data #", "---", "bool success   #", "string message #"],
    "std_srvs/srv/Trigger": ["---", "bool success   #", "string message #"],
    "example_interfaces/srv/AddTwoInts": ["int64 a", "int64 b", "---", "int64 sum"],
    "example_interfaces/action/Fibonacci": [
        "#", "int32 order", "---", "#", "int32[] sequence", "---", "#", "int32[] sequence",
    ],
    "action_tutorials_interfaces/action/Fibonacci": [
        "int32 order", "---", "int32[] sequence", "---", "int32[] partial_sequence",
    ],
    "turtlesim/msg/Color": ["uint8 r", "uint8 g", "uint8 b"],
    "turtlesim/msg/Pose": [
        "float32 x", "float32 y", "float32 theta", "", "float32 linear_velocity", "float32 angular_velocity",
    ],
    "turtlesim/srv/Kill": ["string name", "---"],
    "turtlesim/srv/SetPen": ["uint8 r", "uint8 g", "uint8 b", "uint8 width", "uint8 off", "---"],
    "turtlesim/srv/Spawn": ["float32 x", "float32 y", "float32 theta", "string name #", "---", "string name"],
    "turtlesim/srv/TeleportAbsolute": ["float32 x", "float32 y", "float32 theta", "---"],
    "turtlesim/srv/TeleportRelative": ["float32 linear", "float32 angular", "---"],
    "turtlesim/action/RotateAbsolute": ["#", "float32 theta", "---", "#", "float32 delta", "---", "#", "float32 remaining"],
}  # fmt: skip
"""Lines of interfaces that pages print; a comment, of one line or more, stands here as its `#`."""


def form(lines):
    """The lines without the words of their comments; a comment of several lines is one."""
    bare = [re.sub(r"#.*", "#", line) for line in lines]
    return [line for at, line in enumerate(bare) if not (line == "#" and at and bare[at - 1] == "#")]


@pytest.mark.parametrize("name", PRINTED)
def test_fields_constants_and_blank_lines_stand_as_a_page_prints_them(name):
    assert form(shown(name)) == PRINTED[name]


@pytest.mark.parametrize(
    "name", ["sensor_msgs/msg/BatteryState", "rcl_interfaces/msg/ParameterType", "action_msgs/msg/GoalStatus"]
)
def test_constants_are_shown_with_their_values(name):
    assert any(re.match(r"u?int8 [A-Z_]+ *= *\d+", line) for line in shown(name))
