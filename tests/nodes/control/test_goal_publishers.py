"""The programs that send a controller its goals in turn, as the demos of ros2_control start them."""

import pytest
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64MultiArray
from trajectory_msgs.msg import JointTrajectory

from tests.nodes.control.conftest import JOINTS

PACKAGE = "ros2_controllers_test_nodes"
FORWARD = """publisher_forward_position_controller:
  ros__parameters:
    publish_topic: /forward/commands
    wait_sec_between_publish: 2
    goal_names: [up, down]
    up: [1, 2]
    down: [0.0, -0.25]
"""
TRAJECTORY = f"""publisher_joint_trajectory_controller:
  ros__parameters:
    controller_name: arm_controller
    wait_sec_between_publish: 5
    goal_names: [first, second]
    first: {{positions: [0.3, 0.1, 0.0, 0.0, 0.0, 0.2], velocities: [0.0]}}
    second: {{positions: [0.0, 0.0, 0.0, 0.0, 0.0, 0.0]}}
    joints: {JOINTS}
    check_starting_point: true
    starting_point_limits: {{joint2: [LOW, 1.0]}}
"""


def place(states, joint):
    return states.position[list(states.name).index(joint)]


@pytest.fixture
def publisher(run, tmp_path):
    """publisher("forward_position", yaml) starts one with its parameters."""

    def start(kind, text):
        (tmp_path / "goals.yaml").write_text(text)
        name = f"publisher_{kind}_controller"
        return run(PACKAGE, name, "--ros-args", "-r", f"__node:={name}", "--params-file", str(tmp_path / "goals.yaml"))

    return start


def test_positions_come_in_turn_and_begin_again(publisher, friend):
    heard = friend.hear(Float64MultiArray, "/forward/commands")
    node = publisher("forward_position", FORWARD)
    friend.spin(6.5)
    assert [list(msg.data) for msg in heard] == [[1.0, 2.0], [0.0, -0.25], [1.0, 2.0]]
    assert 'Publishing 2 goals on topic "/forward/commands" every 2 s' in node.output


def test_a_goal_without_values_is_named(publisher):
    node = publisher("forward_position", FORWARD.replace("down: [0.0, -0.25]", ""))
    assert node.wait(5.0) == 1 and 'Values for goal "down" not set!' in node.output


def test_an_arm_goes_from_goal_to_goal(manager, run, publisher, friend):
    manager()
    assert run("controller_manager", "spawner", "joint_state_broadcaster", "arm_controller").wait(20) == 0
    states = friend.hear(JointState, "/joint_states")
    publisher("joint_trajectory", TRAJECTORY.replace("LOW", "-1.0"))
    friend.spin(9.5)
    assert place(states[-1], "joint1") == pytest.approx(0.3, abs=0.01), "the first goal, four seconds after it was sent"
    friend.spin(5.0)
    assert place(states[-1], "joint1") == pytest.approx(0.0, abs=0.01)


def test_an_arm_that_begins_outside_its_limits_gets_no_goal(manager, run, publisher, friend):
    manager()
    assert run("controller_manager", "spawner", "joint_state_broadcaster").wait(20) == 0
    heard = friend.hear(JointTrajectory, "/arm_controller/joint_trajectory")
    node = publisher("joint_trajectory", TRAJECTORY.replace("LOW", "0.5"))
    friend.spin(6.0)
    assert not heard and "Starting point limits exceeded for joint joint2 !" in node.output
    assert "Start configuration is not within configured limits!" in node.output


def test_goals_of_another_length_are_refused(publisher):
    node = publisher("joint_trajectory", TRAJECTORY.replace("LOW", "-1.0").replace(", 0.2]", "]").replace(", 0.0]}", "]}"))
    assert node.wait(5.0) == 1 and "No valid goal found. Exiting..." in node.output
