from __future__ import annotations

import pytest
from launch.actions import EmitEvent, LogInfo, RegisterEventHandler, Shutdown
from launch_ros.actions import LifecycleNode, LifecycleTransition, Node, ROSTimer, SetUseSimTime
from launch_ros.event_handlers import OnStateTransition
from launch_ros.events import matches_node_name
from launch_ros.events.lifecycle import ChangeState
from lifecycle_msgs.msg import Transition

USER = "[INFO] [launch.user]: "

LIFECYCLE = """
import rclpy
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn


class Quiet(LifecycleNode):
    def on_configure(self, state):
        self.get_logger().info('configuring')
        return TransitionCallbackReturn.SUCCESS


def main():
    rclpy.init()
    try:
        rclpy.spin(Quiet('quiet'))
    except KeyboardInterrupt:
        pass


main()
"""
CLOCK = """
import rclpy
from rosgraph_msgs.msg import Clock

rclpy.init()
node = rclpy.create_node('clock')
publisher = node.create_publisher(Clock, '/clock', 10)
seconds = 0


def tick():
    global seconds
    seconds += 10
    message = Clock()
    message.clock.sec = seconds
    publisher.publish(message)


node.create_timer(1.0, tick)
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    pass
"""


@pytest.fixture
def node(workspace) -> LifecycleNode:
    workspace.executable("demo", "quiet", LIFECYCLE)
    return LifecycleNode(package="demo", executable="quiet", name="quiet", namespace="ns", output="screen")


def change(node: LifecycleNode, transition: int) -> EmitEvent:
    return EmitEvent(
        event=ChangeState(lifecycle_node_matcher=lambda action: action is node, transition_id=transition)
    )


def test_a_lifecycle_node_changes_its_state_by_events(launch, node: LifecycleNode) -> None:
    result = launch(
        [
            RegisterEventHandler(
                OnStateTransition(
                    target_lifecycle_node=node,
                    goal_state="inactive",
                    entities=[LogInfo(msg="configured"), change(node, Transition.TRANSITION_ACTIVATE)],
                )
            ),
            RegisterEventHandler(
                OnStateTransition(
                    target_lifecycle_node=node,
                    start_state="activating",
                    goal_state="active",
                    entities=[LogInfo(msg="active"), Shutdown()],
                )
            ),
            node,
            change(node, Transition.TRANSITION_CONFIGURE),
        ]
    )
    said = [line for line in result.lines if line.startswith(USER)]
    assert said == [USER + "configured", USER + "active"], result.text
    assert result.code == 0
    assert "[ns.quiet]: configuring" in result.text


def test_nodes_can_be_taken_through_several_transitions(launch, node: LifecycleNode) -> None:
    result = launch(
        [
            node,
            LifecycleTransition(
                lifecycle_node_names=["/ns/quiet"],
                transition_ids=[Transition.TRANSITION_CONFIGURE, Transition.TRANSITION_ACTIVATE],
            ),
            RegisterEventHandler(
                OnStateTransition(goal_state="active", entities=[LogInfo(msg="there"), Shutdown()])
            ),
        ]
    )
    assert USER + "there" in result.lines


def test_a_refused_transition_is_an_error_line(launch, node: LifecycleNode) -> None:
    result = launch([node, change(node, Transition.TRANSITION_ACTIVATE)], interrupt_after=5.0)
    assert (
        "[ERROR] [launch_ros.actions.lifecycle_node]: Failed to make transition 'TRANSITION_ACTIVATE' for "
        "LifecycleNode '/ns/quiet'" in result.lines
    )


def test_waiting_for_a_node_that_never_comes_ends_with_the_launch(launch, workspace) -> None:
    workspace.executable("demo", "nothing", "import time; time.sleep(100.0)")
    node = LifecycleNode(package="demo", executable="nothing", name="n", namespace="")
    result = launch([node, change(node, Transition.TRANSITION_CONFIGURE)], interrupt_after=3.0)
    assert "Abandoning wait for the" in result.text


def test_only_known_transitions_can_be_asked_for() -> None:
    with pytest.raises(ValueError, match="expected one of: 1 "):
        ChangeState(lifecycle_node_matcher=lambda action: True, transition_id=99)
    assert ChangeState.valid_states[2] == "inactive"
    assert ChangeState.valid_states[10] == "configuring"


def test_a_handler_takes_a_matcher_or_what_to_match() -> None:
    with pytest.raises(RuntimeError, match="not both"):
        OnStateTransition(matcher=lambda event: True, goal_state="active", entities=[])


def test_nodes_are_matched_by_their_full_name() -> None:
    class Action:
        node_name = "/ns/quiet"

    assert matches_node_name("ns/quiet")(Action())
    assert not matches_node_name("/quiet")(Action())


def test_a_ros_timer_waits_on_the_launchs_clock(launch, session) -> None:
    result = launch([ROSTimer(period=3.0, actions=[LogInfo(msg="now")])])
    assert result.lines == [USER + "now"]
    assert session.clock.steady() == 3_000_000_000


def test_a_ros_timer_waits_on_simulated_time_when_that_is_used(launch, workspace, session) -> None:
    workspace.executable("demo", "clock", CLOCK)
    result = launch(
        [
            Node(package="demo", executable="clock"),
            SetUseSimTime(True),
            ROSTimer(period=25.0, actions=[LogInfo(msg="now"), Shutdown()]),
        ]
    )
    assert USER + "now" in result.lines
    assert session.clock.steady() < 10e9
