"""An arm with mock hardware: controllers are spawned, trajectories followed, and all tell the same."""

import math
import re

import pytest
from builtin_interfaces.msg import Duration
from control_msgs.action import FollowJointTrajectory, GripperCommand
from control_msgs.msg import JointTolerance
from controller_manager_msgs.srv import ConfigureController, ListControllers
from rclpy.action import ActionClient
from rclpy.time import Time
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64MultiArray
from tf2_ros import Buffer, TransformListener
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

from tests.nodes.control.conftest import JOINTS, PARAMETERS

Result = FollowJointTrajectory.Result


def trajectory(*points, joints=JOINTS):
    """Positions and times as a message."""
    trajectory_points = [
        JointTrajectoryPoint(positions=list(map(float, positions)), time_from_start=Duration(sec=time))
        for positions, time in points
    ]
    return JointTrajectory(joint_names=list(joints), points=trajectory_points)


def send(friend, kind, name, goal, seconds=20.0):
    """The result of an action, and its status; None where it is rejected."""
    client = ActionClient(friend.node, kind, name)
    assert client.wait_for_server(timeout_sec=5.0)
    asked = client.send_goal_async(goal)
    friend.executor.spin_until_future_complete(asked, timeout_sec=seconds)
    if not asked.result().accepted:
        return None, None
    answer = asked.result().get_result_async()
    friend.executor.spin_until_future_complete(answer, timeout_sec=seconds)
    return answer.result().result, answer.result().status


@pytest.fixture
def arm(manager, run):
    """The arm with its controllers active."""
    node = manager()
    assert run("controller_manager", "spawner", "joint_state_broadcaster", "arm_controller").wait(20) == 0
    return node


def test_a_goal_moves_the_arm_and_joint_states_and_tf_agree(arm, friend):
    states = friend.hear(JointState, "/joint_states")
    buffer = Buffer()
    TransformListener(buffer, friend.node)
    friend.spin(0.5)
    before = dict(zip(states[-1].name, states[-1].position, strict=True))
    assert before["joint2"] == pytest.approx(0.2), "its initial value"
    goal = FollowJointTrajectory.Goal(trajectory=trajectory(([0.5, 0.4, 0, 0, 0, 1.0], 1), ([1, 0, 0, 0, 0, 0], 2)))
    result, status = send(friend, FollowJointTrajectory, "/arm_controller/follow_joint_trajectory", goal)
    assert (result.error_code, status) == (Result.SUCCESSFUL, 4)
    friend.spin(0.5)
    after = dict(zip(states[-1].name, states[-1].position, strict=True))
    assert after["joint1"] == pytest.approx(1.0) and after["joint2"] == pytest.approx(0.0)
    turn = buffer.lookup_transform("base_link", "link1", Time())
    assert 2 * math.atan2(turn.transform.rotation.z, turn.transform.rotation.w) == pytest.approx(1.0, abs=1e-3)


def test_a_topic_s_trajectory_is_followed_and_half_way_the_arm_is_half_way(arm, friend):
    states = friend.hear(JointState, "/joint_states")
    out = friend.node.create_publisher(JointTrajectory, "/arm_controller/joint_trajectory", 10)
    friend.spin(0.2)
    out.publish(trajectory(([1.0, 0.2, 0, 0, 0, 0], 2)))
    friend.spin(1.0)
    assert dict(zip(states[-1].name, states[-1].position, strict=True))["joint1"] == pytest.approx(0.5, abs=0.02)


def test_a_tolerance_that_is_violated_aborts_with_the_code_of_ros(arm, friend):
    goal = FollowJointTrajectory.Goal(trajectory=trajectory(([2.0, 0, 0, 0, 0, 0], 1)))
    goal.path_tolerance = [JointTolerance(name="joint1", position=1e-6)]
    result, status = send(friend, FollowJointTrajectory, "/arm_controller/follow_joint_trajectory", goal)
    assert (result.error_code, status) == (Result.PATH_TOLERANCE_VIOLATED, 6)
    assert "Aborted due to state tolerance violation" in arm.output


def test_a_goal_that_is_not_reached_in_time_aborts_with_the_code_of_ros(manager, run, friend):
    """The hardware stays a tenth of a radian beside what it is told: within the path's tolerance, not within the goal's."""
    node = manager(settings="<param name='position_state_following_offset'>0.1</param>")
    assert run("controller_manager", "spawner", "arm_controller").wait(20) == 0
    goal = FollowJointTrajectory.Goal(trajectory=trajectory(([1.0, 0, 0, 0, 0, 0], 1)))
    result, status = send(friend, FollowJointTrajectory, "/arm_controller/follow_joint_trajectory", goal)
    assert (result.error_code, status) == (Result.GOAL_TOLERANCE_VIOLATED, 6)
    assert re.fullmatch(r"Aborted due goal_time_tolerance exceeding by 0\.5\d+ seconds", result.error_string)
    assert result.error_string in node.output
    goal.goal_tolerance = [JointTolerance(name=name, position=0.2) for name in JOINTS]
    result, status = send(friend, FollowJointTrajectory, "/arm_controller/follow_joint_trajectory", goal)
    assert (result.error_code, status) == (Result.SUCCESSFUL, 4), "the goal's own tolerance comes first"


def test_a_goal_that_cannot_be_followed_is_rejected_and_why_is_said(arm, friend):
    for joints, points, says in (
        (["a"], [([0], 1)], "don't match the controller joints"),
        ([*JOINTS[:5], "elbow"], [([0] * 6, 1)], "Incoming joint elbow doesn't match"),
        (JOINTS, [], "Empty trajectory"),
        (JOINTS, [([0] * 6, 2), ([0] * 6, 1)], "not strictly increasing"),
        (JOINTS, [([0] * 5, 1)], "Mismatch between joint_names size (6) and positions (5)"),
        (JOINTS, [([math.nan] * 6, 1)], "no finite numbers"),
    ):
        goal = FollowJointTrajectory.Goal(trajectory=trajectory(*points, joints=joints))
        assert send(friend, FollowJointTrajectory, "/arm_controller/follow_joint_trajectory", goal) == (None, None)
        assert says in arm.output
    old = FollowJointTrajectory.Goal(trajectory=trajectory(([0] * 6, 1)))
    old.trajectory.header.stamp.sec = 5
    assert send(friend, FollowJointTrajectory, "/arm_controller/follow_joint_trajectory", old) == (None, None)
    assert "that ends in the past (6.000000)" in arm.output


def test_a_goal_that_is_canceled_holds_the_arm_where_it_is(arm, friend):
    states = friend.hear(JointState, "/joint_states")
    client = ActionClient(friend.node, FollowJointTrajectory, "/arm_controller/follow_joint_trajectory")
    assert client.wait_for_server(timeout_sec=5.0)
    asked = client.send_goal_async(FollowJointTrajectory.Goal(trajectory=trajectory(([2.0, 0, 0, 0, 0, 0], 4))))
    friend.executor.spin_until_future_complete(asked, timeout_sec=5.0)
    friend.spin(1.0)
    canceled = asked.result().cancel_goal_async()
    friend.executor.spin_until_future_complete(canceled, timeout_sec=5.0)
    answer = asked.result().get_result_async()
    friend.executor.spin_until_future_complete(answer, timeout_sec=5.0)
    friend.spin(2.0)
    at = dict(zip(states[-1].name, states[-1].position, strict=True))["joint1"]
    assert answer.result().status == 5 and at == pytest.approx(0.5, abs=0.05)


def test_a_newer_goal_takes_over(arm, friend):
    client = ActionClient(friend.node, FollowJointTrajectory, "/arm_controller/follow_joint_trajectory")
    assert client.wait_for_server(timeout_sec=5.0)
    first = client.send_goal_async(FollowJointTrajectory.Goal(trajectory=trajectory(([2.0, 0, 0, 0, 0, 0], 9))))
    friend.executor.spin_until_future_complete(first, timeout_sec=5.0)
    goal = FollowJointTrajectory.Goal(trajectory=trajectory(([-0.5, 0, 0, 0, 0, 0], 1)))
    _, status = send(friend, FollowJointTrajectory, "/arm_controller/follow_joint_trajectory", goal)
    answer = first.result().get_result_async()
    friend.executor.spin_until_future_complete(answer, timeout_sec=5.0)
    assert (status, answer.result().status) == (4, 6)


def test_the_gripper_closes_and_its_other_finger_mimics(arm, friend, run):
    assert run("controller_manager", "spawner", "gripper").wait(20) == 0
    states = friend.hear(JointState, "/joint_states")
    goal = GripperCommand.Goal()
    goal.command.position = 0.03
    result, status = send(friend, GripperCommand, "/gripper/gripper_cmd", goal)
    friend.spin(0.2)
    now = dict(zip(states[-1].name, states[-1].position, strict=True))
    assert status == 4 and result.reached_goal and now["finger"] == now["finger2"] == pytest.approx(0.03)


def test_joints_of_one_controller_are_no_other_s_until_they_are_switched(arm, friend, run, ros2):
    assert run("controller_manager", "spawner", "forward", "--inactive").wait(20) == 0
    says = ros2("control", "switch_controllers", "--activate", "forward", "--strict")
    assert "Error switching controllers, check controller_manager logs" in says
    assert "Resource conflict for controller 'forward'. Command interface 'joint1/position' is already" in arm.output
    says = ros2("control", "switch_controllers", "--activate", "forward", "--deactivate", "arm_controller", "--strict")
    assert says == "Successfully switched controllers\n"
    states = friend.hear(JointState, "/joint_states")
    out = friend.node.create_publisher(Float64MultiArray, "/forward/commands", 10)
    friend.spin(0.2)
    out.publish(Float64MultiArray(data=[0.1, 0.2, 0.3, 0.4, 0.5, 0.6]))
    friend.spin(0.2)
    assert list(states[-1].position[:6]) == pytest.approx([0.1, 0.2, 0.3, 0.4, 0.5, 0.6])
    out.publish(Float64MultiArray(data=[0.1]))
    friend.spin(0.2)
    assert "command size (1) does not match number of interfaces (6)" in arm.output


def test_what_the_command_tells(arm, ros2, run):
    listed = ros2("control", "list_controllers")
    assert "joint_state_broadcaster[joint_state_broadcaster/JointStateBroadcaster] active" in listed
    assert "\tjoint1/position [available] [claimed]" in ros2("control", "list_hardware_interfaces").splitlines()
    assert "plugin name: mock_components/GenericSystem" in ros2("control", "list_hardware_components")
    assert "controller_interface::ControllerInterface" in ros2("control", "list_controller_types")
    assert ros2("control", "load_controller", "forward") == "Successfully loaded controller forward\n"
    assert ros2("control", "set_controller_state", "forward", "inactive") == "Successfully configured forward\n"
    says = "Successfully deactivated arm_controller\n"
    assert ros2("control", "set_controller_state", "arm_controller", "inactive") == says
    assert ros2("control", "set_controller_state", "none", "active") == "controller none does not seem to be loaded\n"
    assert ros2("control", "unload_controller", "forward") == "Successfully unloaded controller forward\n"
    assert run("controller_manager", "unspawner", "arm_controller").wait(20) == 0


def test_a_controller_that_has_no_type_or_an_unknown_one_is_told(manager, run):
    node = manager(parameters=PARAMETERS + "    type: x\n")
    assert run("controller_manager", "spawner", "nobody").wait(20) == 1
    assert "The 'type' param was not defined for 'nobody'." in node.output
    assert run("controller_manager", "spawner", "nobody", "-t", "a/B").wait(20) == 1
    assert "Loader for controller 'nobody' (type 'a/B') not found." in node.output


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        (f"joints: {JOINTS}\n    command", "joints: []\n    command", "'joints' parameter is empty"),
        ("command_interfaces: [position]", "command_interfaces: [steam]", "interface 'steam' is not known"),
        ("state_interfaces: [position, velocity]", "state_interfaces: [velocity]", "must have at least 'position'"),
        ("goal_time: 0.5", "goal_time: soon", "constraints.goal_time"),
    ],
)
def test_a_controller_with_wrong_parameters_is_not_configured_and_says_why(manager, run, old, new, says):
    node = manager(parameters=PARAMETERS.replace(old, new, 1))
    assert run("controller_manager", "spawner", "arm_controller").wait(20) == 1
    assert says in node.output and "Traceback" not in node.output


def test_a_spawner_that_is_killed_with_u_unloads_its_controllers(manager, run, ros2):
    manager()
    spawner = run("controller_manager", "spawner", "joint_state_broadcaster", "-u")
    spawner.wait(3)
    assert "joint_state_broadcaster" in ros2("control", "list_controllers")
    spawner.interrupt()
    spawner.wait(5)
    assert ros2("control", "list_controllers") == ""


def test_without_a_manager_the_command_says_so(ros2):
    says = ros2("control", "list_controllers", seconds=30.0)
    assert says.strip() == "Could not contact service /controller_manager/list_controllers"


def service(friend, kind, called, **fields):
    """The answer of a service of the manager."""
    client = friend.node.create_client(kind, f"/controller_manager/{called}")
    assert client.wait_for_service(timeout_sec=5.0)
    asked = client.call_async(kind.Request(**fields))
    friend.executor.spin_until_future_complete(asked, timeout_sec=5.0)
    return asked.result()


def test_an_inactive_controller_is_cleaned_up_and_configured_anew(manager, run, friend, ros2):
    """Configuring again reads the parameters again; an active controller is not touched."""
    node = manager()
    assert run("controller_manager", "spawner", "forward", "--inactive").wait(20) == 0
    assert "Set parameter successful" in ros2("param", "set", "/forward", "joints", "['joint2', 'joint3']")
    assert service(friend, ConfigureController, "configure_controller", name="forward").ok
    (told,) = service(friend, ListControllers, "list_controllers").controller
    assert told.required_command_interfaces == ["joint2/position", "joint3/position"]
    assert ros2("topic", "info", "/forward/commands").endswith("Subscription count: 1\n")
    assert "Successfully switched" in ros2("control", "switch_controllers", "--activate", "forward")
    assert not service(friend, ConfigureController, "configure_controller", name="forward").ok
    assert "Controller 'forward' can not be configured from 'active' state." in node.output


def test_a_trajectory_controller_configured_anew_has_one_action_and_follows(arm, friend, ros2):
    assert "Successfully switched" in ros2("control", "switch_controllers", "--deactivate", "arm_controller")
    assert service(friend, ConfigureController, "configure_controller", name="arm_controller").ok
    assert "Successfully switched" in ros2("control", "switch_controllers", "--activate", "arm_controller")
    info = ros2("action", "info", "/arm_controller/follow_joint_trajectory")
    assert "Action servers: 1\n" in info
    goal = FollowJointTrajectory.Goal(trajectory=trajectory(([0.5, 0, 0, 0, 0, 0], 1)))
    result, status = send(friend, FollowJointTrajectory, "/arm_controller/follow_joint_trajectory", goal)
    assert (result.error_code, status) == (Result.SUCCESSFUL, 4)


def test_a_controller_in_a_chain_is_refused_where_the_other_exports_nothing(manager, run, ros2):
    """A chain needs a controller that takes references; the trajectory controller takes none, as ros2_control says."""
    head = "forward:\n  ros__parameters:\n    joints: "
    chained = PARAMETERS.replace(f"{head}{JOINTS}", f"{head}[arm_controller/joint1]")
    node = manager(parameters=chained)
    assert run("controller_manager", "spawner", "arm_controller").wait(20) == 0
    assert run("controller_manager", "spawner", "forward").wait(20) == 1
    says = "No reference interface 'arm_controller/joint1/position' exist, since the following controller with name "
    assert f"{says}'arm_controller' is not chainable." in node.output
    line = r"forward +\[forward_command_controller/ForwardCommandController\] inactive"
    assert re.search(line, ros2("control", "list_controllers"))
