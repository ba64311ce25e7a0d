"""tf2 in Python: frames that stay, frames that move, listeners, a frame of one's own, time and the past."""

import importlib
import math
import re

import pytest


def test_the_introduction_s_demo(terminal, said):
    terminal("ros2 launch turtle_tf2_py turtle_tf2_demo.launch.py", 3.0)
    said("ros2 run tf2_tools view_frames", 8.0)
    echo = said("ros2 run tf2_ros tf2_echo turtle2 turtle1", 2.5)
    assert "- Translation: [" in echo and "- Rotation: in Quaternion [" in echo and "- Rotation: in RPY (degree) [" in echo


def test_a_static_broadcaster(terminal, said):
    terminal("ros2 run path_py fixed mystaticturtle 0 0 1 0 0 0", 0.5)
    echo = said("ros2 topic echo --once --qos-durability transient_local /tf_static")
    assert "frame_id: world" in echo and "child_frame_id: mystaticturtle" in echo and "z: 1.0" in echo


def test_the_static_publisher_of_tf2_ros(terminal, said):
    terminal(
        "ros2 run tf2_ros static_transform_publisher --x 0 --y 0 --z 1 --yaw 0 --pitch 0 --roll 0 "
        "--frame-id world --child-frame-id mystaticturtle", 0.5,
    )  # fmt: skip
    assert "- Translation: [0.000, 0.000, 1.000]" in said("ros2 run tf2_ros tf2_echo world mystaticturtle", 1.5)


@pytest.mark.parametrize(("options", "apart"), [("", 0.0), ("target_frame:=carrot1", 2.0), ("delay:=2.0", 0.0)])
def test_a_turtle_follows_a_frame_also_where_it_was(terminal, said, options, apart):
    """It comes to the frame that it follows: turtle1 itself, now or two seconds ago, or two metres beside it."""
    launch = terminal(f"ros2 launch path_py follow.launch.py {options}", 20.0)
    echo = said("ros2 run tf2_ros tf2_echo turtle2 turtle1", 1.5)
    x, y, _ = map(float, re.findall(r"Translation: \[(.*)\]", echo)[-1].split(","))
    assert math.hypot(x, y) == pytest.approx(apart, abs=0.05), launch.output[-400:]


def test_debugging_what_does_not_exist(terminal, said):
    terminal("ros2 launch path_py follow.launch.py target_frame:=turtle3", 4.0)
    echo = said("ros2 run tf2_ros tf2_echo turtle3 turtle1", 2.5)
    assert 'Invalid frame ID "turtle3" passed to canTransform argument target_frame - frame does not exist' in echo
    assert "Net delay" in said("ros2 run tf2_ros tf2_monitor turtle2 turtle1", 12.0)


def test_points_wait_for_their_frames(terminal):
    launch = terminal("ros2 launch turtle_tf2_py turtle_tf2_sensor_message.launch.py", 4.0)
    assert "died" not in launch.output
    listener = terminal("ros2 run turtle_tf2_cpp turtle_tf2_message_filter", 2.0)
    assert "Point of turtle3 in frame of turtle1: x:" in listener.output


@pytest.mark.parametrize("module", ["turtle_tf2_broadcaster", "static_turtle_tf2_broadcaster"])
def test_quaternions_are_made_by_the_turtles_broadcasters(module):
    """The page about quaternions takes its function from there, and inverts what it gives in place."""
    q = importlib.import_module(f"turtle_tf2_py.{module}").quaternion_from_euler(math.pi, 0, 0)
    q[3] = -q[3]
    assert q == pytest.approx([1, 0, 0, 0])
