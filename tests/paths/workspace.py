"""A workspace with a message, a node, three launch files and a map, made as students make one, in a folder of any name."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from tests.needs import ON_WINDOWS

HOSTILE = "ñ o' $(touch PWNED) `touch PWNED` %d" if ON_WINDOWS else "ñ o' \"\"\" \\n $(touch PWNED) `touch PWNED` %d"
"""A name in which a space, an accent, quotes, a backslash, commands of a shell and a format stand for themselves.

Windows has no names with a double quotation mark or a backslash.
"""

BIN = Path(sys.executable).parent
_CREATE = """
cd src
ros2 pkg create talks_msgs --maintainer-email ada@example.com
ros2 pkg create talks --build-type ament_python --node-name talk --maintainer-email ada@example.com --dependencies rclpy
"""
_NODE = '''
import rclpy
from rclpy.node import Node

from talks_msgs.msg import Count


def main():
    rclpy.init()
    node = Node("talk")
    publisher = node.create_publisher(Count, "count", 10)
    node.create_timer(0.1, lambda: publisher.publish(Count(number=7)))
    node.get_logger().info(f"told by {Count().teller}")
    rclpy.spin(node)
'''
_PYTHON = '''
import os
from ament_index_python import get_package_share_directory
from launch import LaunchDescription
from launch.actions import ExecuteProcess, TimerAction
from launch.substitutions import Command, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    robot = Command(["xacro ", PathJoinSubstitution([FindPackageShare("talks"), "robot.urdf.xacro"])])
    map_file = os.path.join(get_package_share_directory("talks"), "room.yaml")
    save = ["ros2", "run", "nav2_map_server", "map_saver_cli", "-f", os.path.abspath("saved room")]
    return LaunchDescription([
        Node(package="talks", executable="talk", output="screen"),
        Node(package="robot_state_publisher", executable="robot_state_publisher", output="screen",
             parameters=[{"robot_description": ParameterValue(robot, value_type=str)}]),
        Node(package="nav2_map_server", executable="map_server", parameters=[{"yaml_filename": map_file}]),
        Node(package="nav2_lifecycle_manager", executable="lifecycle_manager", name="manager",
             parameters=[{"autostart": True, "node_names": ["map_server"]}]),
        TimerAction(period=2.0, actions=[ExecuteProcess(cmd=save, output="screen")]),
    ])
'''
_XML = """<launch>
  <include file="$(find-pkg-share talks)/inner.launch.py"/>
  <let name="here" value="$(find-pkg-share talks)"/>
  <executable cmd="ls '$(find-pkg-share talks)/room.yaml'" output="screen"/>
  <executable cmd="ls $(find-pkg-share talks)/room.yaml" output="screen"/>
  <node pkg="demo_nodes_py" exec="talker" args="--ros-args --params-file $(find-pkg-share talks)/talker.yaml"/>
  <node pkg="talks" exec="talk" output="screen"><param from="$(var here)/talk.yaml"/></node>
</launch>
"""
_YAML = """launch:
- include: {file: "$(find-pkg-share talks)/pair.launch.xml"}
"""
_INNER = """
from launch import LaunchDescription
from launch.actions import LogInfo
from launch.substitutions import ThisLaunchFileDir


def generate_launch_description():
    return LaunchDescription([LogInfo(msg=["included from ", ThisLaunchFileDir()])])
"""
# xacro looks for $(...) in what $(find talks) gives, too, and refuses what it does not know: here files are named without it
_ROBOT = """<robot name="cart" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="wheel.xacro"/>
  <link name="base"><visual><geometry><mesh filename="package://talks/body.stl"/></geometry></visual></link>
</robot>
"""
_WHEEL = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="wheel"/>
  <joint name="axle" type="fixed"><parent link="base"/><child link="wheel"/></joint>
</robot>
"""
_MAP = "image: 'the room.pgm'\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n"
_FILES = {
    "all.launch.py": _PYTHON,
    "pair.launch.xml": _XML,
    "whole.launch.yaml": _YAML,
    "inner.launch.py": _INNER,
    "talk.yaml": "/**:\n  ros__parameters:\n    speed: 1.0\n",
    "talker.yaml": "/**:\n  ros__parameters:\n    speed: 1.0\n",
    "robot.urdf.xacro": _ROBOT,
    "wheel.xacro": _WHEEL,
    "body.stl": "solid s\nendsolid s\n",
    "room.yaml": _MAP,
    "the room.pgm": "P2 3 2 255\n0 254 254\n205 254 0\n",
}


def environment(**more: str) -> dict[str, str]:
    """What a terminal has in which nothing is sourced."""
    env = {name: value for name, value in os.environ.items() if name not in ("AMENT_PREFIX_PATH", "PYTHONPATH")}
    env["PATH"] = f"{BIN}{os.pathsep}{env['PATH']}"
    return {**env, "COURSEKIT_TIME": "virtual", "COURSEKIT_STOP_AFTER": "6", **more}


def type_in(folder: Path, lines: str, *words: str) -> str:
    """What bash prints to lines that are typed in a folder; $1 and so on are `words`. AssertionError where one fails."""
    command = ["bash", "-e", "-c", lines, "bash", *words]
    done = subprocess.run(
        command, cwd=folder, env=environment(), capture_output=True, encoding="utf-8", errors="replace", check=False
    )
    said = done.stdout + done.stderr
    assert done.returncode == 0, said
    return said


def make(folder: Path) -> None:
    """Create the packages and write their files."""
    (folder / "src").mkdir(parents=True)
    type_in(folder, _CREATE)
    messages, package = folder / "src" / "talks_msgs", folder / "src" / "talks"
    (messages / "msg").mkdir()
    (messages / "msg" / "Count.msg").write_text("int32 number\nstring teller \"the ñ's\"\n", encoding="utf-8")
    _replace(
        messages / "CMakeLists.txt",
        "ament_package()",
        "find_package(rosidl_default_generators REQUIRED)\n"
        'rosidl_generate_interfaces(${PROJECT_NAME} "msg/Count.msg")\nament_package()',
    )
    group = "<member_of_group>rosidl_interface_packages</member_of_group>"
    _replace(messages / "package.xml", "  <export>", f"  {group}\n  <export>")
    _replace(package / "package.xml", "<depend>rclpy</depend>", "<depend>rclpy</depend><depend>talks_msgs</depend>")
    (package / "talks" / "talk.py").write_text(_NODE, encoding="utf-8")
    for name, text in _FILES.items():
        (package / name).write_text(text, encoding="utf-8")
    _replace(package / "setup.py", "['package.xml']", f"['package.xml', {', '.join(map(repr, _FILES))}]")


def _replace(file: Path, old: str, new: str) -> None:
    text = file.read_text(encoding="utf-8")
    assert old in text
    file.write_text(text.replace(old, new), encoding="utf-8")
