"""Commands of substitutions that ask the session's nodes, as launch files of real robots do for a description."""

from __future__ import annotations

import pytest
from launch.actions import LogInfo, TimerAction
from launch.substitutions import Command, SubstitutionFailure
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue

SHOW = """
import rclpy
rclpy.init()
node = rclpy.create_node('show')
node.declare_parameter('robot_description', '')
print('got', node.get_parameter('robot_description').value.strip())
"""


def test_a_node_gets_a_parameter_that_another_was_asked_for(launch, talker) -> None:
    talker.executable("demo", "show", SHOW)
    asked = Command("ros2 param get --hide-type /talker text")
    show = Node(
        package="demo",
        executable="show",
        parameters=[{"robot_description": ParameterValue(asked, value_type=str)}],
        output="screen",
    )
    first = Node(package="demo", executable="talker", parameters=[{"text": "<robot/>"}])
    result = launch([first, TimerAction(period=2.0, actions=[show])], interrupt_after=4.0)
    assert "[show-2] got <robot/>" in result.lines


def test_the_nodes_of_the_launch_are_listed(launch, talker) -> None:
    listed = TimerAction(period=1.0, actions=[LogInfo(msg=Command(["ros2 node", " list"]))])
    result = launch([Node(package="demo", executable="talker"), listed], interrupt_after=2.0)
    assert "[INFO] [launch.user]: /talker" in result.text


def test_a_question_that_no_node_answers_is_a_failure_with_what_was_said(context) -> None:
    with pytest.raises(SubstitutionFailure, match="Captured stderr output: Node not found"):
        Command("ros2 param get /nobody text").perform(context)
