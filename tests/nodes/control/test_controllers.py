"""Other controllers, other hardware, and other ways to start them."""

import math
import re

import pytest
from control_msgs.action import FollowJointTrajectory
from controller_manager_msgs.srv import SetHardwareComponentState, SwitchController
from geometry_msgs.msg import TwistStamped, WrenchStamped
from lifecycle_msgs.msg import State
from nav_msgs.msg import Odometry
from sensor_msgs.msg import Imu, JointState, Range

from coursekit.nodes.control.description import read_hardware
from coursekit.sim.motors import Motors, Reach
from coursekit.urdf import UrdfError
from tests.nodes.control.test_arm import send, trajectory

WHEELS = "".join(
    f"<joint name='{side}'><command_interface name='velocity'/><state_interface name='position'/>"
    "<state_interface name='velocity'/></joint>"
    for side in ("left", "right")
)
AXES = "".join(f"<state_interface name='{kind}.{axis}'/>" for kind in ("force", "torque") for axis in "xyz")
FELT = "".join(f"<state_interface name='orientation.{axis}'/>" for axis in "xyzw")
FELT += "".join(f"<state_interface name='{k}.{a}'/>" for k in ("angular_velocity", "linear_acceleration") for a in "xyz")
CART = f"""<robot name='cart'><link name='base_link'/><link name='l'/><link name='r'/>
<joint name='left' type='continuous'><parent link='base_link'/><child link='l'/></joint>
<joint name='right' type='continuous'><parent link='base_link'/><child link='r'/></joint>
<ros2_control name='cart' type='system'><hardware><plugin>mock_components/GenericSystem</plugin>
<param name='calculate_dynamics'>true</param></hardware>{WHEELS}<sensor name='wrist'>{AXES}</sensor>
<sensor name='imu'>{FELT}</sensor><sensor name='sonar'><state_interface name='range'><param name='initial_value'>1.5</param>
</state_interface></sensor></ros2_control></robot>"""
PARAMETERS = """controller_manager:
  ros__parameters:
    drive: {type: diff_drive_controller/DiffDriveController}
    states: {type: joint_state_broadcaster/JointStateBroadcaster}
    wrench: {type: force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster}
    imu: {type: imu_sensor_broadcaster/IMUSensorBroadcaster}
    sonar: {type: range_sensor_broadcaster/RangeSensorBroadcaster}
    arm: {type: joint_trajectory_controller/JointTrajectoryController}
drive: {ros__parameters: {left_wheel_names: [left], right_wheel_names: [right], wheel_separation: 0.4, wheel_radius: 0.1}}
states: {ros__parameters: {joints: [right], interfaces: [position], use_local_topics: true, extra_joints: [ghost]}}
wrench: {ros__parameters: {sensor_name: wrist, frame_id: tool0}}
imu: {ros__parameters: {sensor_name: imu, frame_id: imu_link}}
sonar: {ros__parameters: {sensor_name: sonar, frame_id: sonar_link, radiation_type: 1, max_range: 2.0}}
arm:
  ros__parameters:
    joints: [left, right]
    command_interfaces: [velocity]
    state_interfaces: [position, velocity]
    gains: {left: {p: 5.0, ff_velocity_scale: 1.0}, right: {p: 5.0, ff_velocity_scale: 1.0}}
"""


@pytest.fixture
def cart(managed):
    return managed(CART, PARAMETERS)


def test_a_cart_without_hardware_drives_in_its_odometry(cart, run, friend):
    assert run("controller_manager", "spawner", "drive").wait(20) == 0
    odometry = friend.hear(Odometry, "/drive/odom")
    out, msg = friend.node.create_publisher(TwistStamped, "/drive/cmd_vel", 10), TwistStamped()
    msg.twist.linear.x, msg.twist.angular.z = 0.5, 0.5
    for _ in range(20):
        out.publish(msg)
        friend.spin(0.1)
    last = odometry[-1].pose.pose
    assert math.hypot(last.position.x, last.position.y) == pytest.approx(2 * math.sin(0.5), abs=0.05)
    assert 2 * math.atan2(last.orientation.z, last.orientation.w) == pytest.approx(1.0, abs=0.05)
    friend.spin(2.0)
    assert odometry[-1].twist.twist.linear.x == 0.0, "without commands it stops"


LIMITED = """wheel_radius: 0.1, pose_covariance_diagonal: [1.0, 2.0, 3.0, 4.0, 5.0, 6.0], publish_limited_velocity: true,
    left_wheel_radius_multiplier: 2.0, {limits}}}"""
ASKED = "linear.x.has_velocity_limits: true, linear.x.max_velocity: 0.2"


@pytest.mark.parametrize(("limits", "speed"), [(ASKED, 0.2), ("linear.x.max_velocity: 0.2", 0.5)])
def test_limits_count_where_they_are_asked_for(managed, run, friend, limits, speed):
    managed(CART, PARAMETERS.replace("wheel_radius: 0.1}", LIMITED.format(limits=limits)))
    assert run("controller_manager", "spawner", "drive").wait(20) == 0
    odometry, limited = friend.hear(Odometry, "/drive/odom"), friend.hear(TwistStamped, "/drive/cmd_vel_out")
    out, msg = friend.node.create_publisher(TwistStamped, "/drive/cmd_vel", 10), TwistStamped()
    msg.twist.linear.x = 0.5
    for _ in range(10):
        msg.header.stamp = friend.node.get_clock().now().to_msg()
        out.publish(msg)
        friend.spin(0.1)
    assert limited[-1].twist.linear.x == pytest.approx(speed)
    assert odometry[-1].twist.twist.linear.x == pytest.approx(speed), "wheels of two sizes, and straight"
    assert odometry[-1].pose.covariance[::7].tolist() == [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]


def test_a_command_that_is_old_when_it_comes_counts_no_more(cart, run, friend):
    assert run("controller_manager", "spawner", "drive").wait(20) == 0
    odometry = friend.hear(Odometry, "/drive/odom")
    out, msg = friend.node.create_publisher(TwistStamped, "/drive/cmd_vel", 10), TwistStamped()
    msg.twist.linear.x = 0.5
    msg.header.stamp.sec = 1
    for _ in range(5):
        out.publish(msg)
        friend.spin(0.1)
    assert odometry[-1].twist.twist.linear.x == 0.0


def test_broadcasters_tell_what_their_parameters_name(cart, run, friend):
    assert run("controller_manager", "spawner", "states", "wrench", "imu", "sonar").wait(20) == 0
    kinds = (
        (JointState, "/states/joint_states"),
        (WrenchStamped, "/wrench/wrench"),
        (Imu, "/imu/imu"),
        (Range, "/sonar/range"),
    )
    states, wrench, imu, sonar = (friend.hear(*type_and_topic) for type_and_topic in kinds)
    friend.spin(0.5)
    assert list(states[-1].name) == ["right", "ghost"] and list(states[-1].position) == [0.0, 0.0]
    assert (wrench[-1].header.frame_id, imu[-1].header.frame_id) == ("tool0", "imu_link")
    heard = sonar[-1]
    assert (heard.header.frame_id, heard.range, heard.radiation_type) == ("sonar_link", 1.5, Range.INFRARED)
    assert (heard.max_range, heard.field_of_view) == (2.0, pytest.approx(0.52))


def test_a_broadcaster_of_all_states_takes_those_that_are_available(managed, run, friend):
    """As in Humble, what becomes available later is published after the broadcaster's next start."""
    tool = "<ros2_control name='tool' type='system'><hardware><plugin>mock_components/GenericSystem</plugin></hardware>"
    tool += "<joint name='left'><state_interface name='position'/></joint></ros2_control></robot>"
    cart = CART.replace("<joint name='left'><command", "<joint name='front'><command").replace("</robot>", tool)
    all_states = re.sub(r"\nstates: .*", "", PARAMETERS)
    managed(
        cart, all_states.replace("    drive:", "    hardware_components_initial_state: {unconfigured: [tool]}\n    drive:")
    )
    assert run("controller_manager", "spawner", "states").wait(20) == 0
    heard = friend.hear(JointState, "/joint_states")
    friend.spin(0.3)
    assert set(heard[-1].name) == {"front", "right"}
    asked, active = "/controller_manager/set_hardware_component_state", State(label="active")
    assert friend.ask(SetHardwareComponentState, asked, name="tool", target_state=active).ok
    friend.spin(0.3)
    assert set(heard[-1].name) == {"front", "right"}
    for change in ("deactivate_controllers", "activate_controllers"):
        request = {change: ["states"], "strictness": SwitchController.Request.STRICT}
        assert friend.ask(SwitchController, "/controller_manager/switch_controller", **request).ok
    friend.spin(0.3)
    assert set(heard[-1].name) == {"front", "right", "left"}


def test_a_trajectory_is_followed_by_speeds_with_the_gains_of_the_parameters(cart, run, friend):
    assert run("controller_manager", "spawner", "arm").wait(20) == 0
    goal = FollowJointTrajectory.Goal(trajectory=trajectory(([1.0, -1.0], 2), ([1.0, -1.0], 4), joints=["left", "right"]))
    result, status = send(friend, FollowJointTrajectory, "/arm/follow_joint_trajectory", goal)
    assert (result.error_code, status) == (0, 4)


def test_controllers_are_loaded_from_python_and_from_launch_files(cart, run, friend, session, tmp_path):
    from controller_manager import list_controllers, load_controller, switch_controllers
    from controller_manager.controller_manager_services import ServiceNotFoundError

    from coursekit.cli.parser import run as run_cli

    friend.spin(0.5)
    (tmp_path / "load.launch.py").write_text(
        "from launch import LaunchDescription\nfrom launch.actions import ExecuteProcess\n"
        "from controller_manager.launch_utils import generate_load_controller_launch_description as generate\n"
        "def generate_launch_description():\n"
        "    words = ['ros2', 'control', 'load_controller', '--set-state', 'active', 'states']\n"
        "    return LaunchDescription([ExecuteProcess(cmd=words, output='screen'), generate('drive')])\n"
    )
    launched = session.start(lambda: run_cli(["launch", str(tmp_path / "load.launch.py")]), name="ros2")
    friend.spin(5.0)
    assert "Sucessfully loaded controller states into state active" in launched.output
    told = {}

    def ask():
        import rclpy

        rclpy.init()
        asking = rclpy.create_node("asking")
        told["before"] = {
            controller.name: controller.state for controller in list_controllers(asking, "/controller_manager").controller
        }
        told["loaded"] = load_controller(asking, "/controller_manager", "wrench").ok
        told["switched"] = switch_controllers(asking, "/controller_manager", ["states"], [], True, True, 5.0).ok
        try:
            list_controllers(asking, "/nobody", 1.0)
        except ServiceNotFoundError as error:
            told["error"] = str(error)

    session.start(ask, name="asking").wait(20)
    assert told["before"] == {"states": "active", "drive": "active"} and told["loaded"] and told["switched"]
    assert told["error"] == "Could not contact service /nobody/list_controllers"


def test_hardware_that_is_a_driver_is_told_with_what_needs_none(run, tmp_path, friend):
    plugin = "ur_robot_driver/URPositionHardwareInterface"
    (tmp_path / "cart.urdf").write_text(CART.replace("mock_components/GenericSystem", plugin))
    run("robot_state_publisher", "robot_state_publisher", str(tmp_path / "cart.urdf"))
    node = run("controller_manager", "ros2_control_node")
    friend.spin(1.0)
    assert "ur_robot_driver/URPositionHardwareInterface is the driver" in node.output
    assert "mock_components/GenericSystem" in node.output


GEARS = "<transmission name='t'><joint name='up'/></transmission>"


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("type='system'", "type='machine'", "has type 'machine'"),
        ("<plugin>mock_components/GenericSystem</plugin>", "", "names no class"),
        ("<command_interface name='velocity'/>", "<command_interface/>", "has no name"),
        ("<joint name='left'><command", "<joint><command", "has no name"),
        ("<param name='initial_value'>1.5</param>", "<param name='initial_value'>low</param>", "which is no number"),
        ("'calculate_dynamics'>true", "'position_state_following_offset'>a bit", "which is no number"),
        ("</ros2_control>", f"{GEARS}</ros2_control>", "is no joint of the hardware 'cart'"),
    ],
)
def test_a_description_with_faults_is_told_with_its_line(old, new, says):
    with pytest.raises(UrdfError) as caught:
        read_hardware(CART.replace(old, new, 1), "cart.urdf")
    assert says in str(caught.value) and "cart.urdf:" in str(caught.value)


def test_limits_of_interfaces_and_other_parameters_are_text_that_a_driver_reads():
    limited = "'velocity'><param name='min'>{-2*pi}</param><param name='max'>{2*pi}</param></command_interface><state"
    text = CART.replace("'velocity'/><state", limited).replace("'calculate_dynamics'>true", "'frame_offset'>0.1 0 0")
    assert read_hardware(text)[1][0].parameters == {"frame_offset": "0.1 0 0"}


def test_an_effort_moves_a_joint_until_its_end():
    motors = Motors({}, {"arm": Reach(-1.0, 1.0, 2.0, 10.0)})
    motors.command("arm", "effort", 5.0)
    motors.step(0.1)
    assert (motors.angles["arm"], motors.speeds["arm"]) == pytest.approx((0.1, 1.0))
    for _ in range(30):
        motors.step(0.1)
    assert motors.angles["arm"] == 1.0


PREFIXES = [("", ("r1/odom", "r1/base_link")), ("tf_frame_prefix: left, ", ("left/odom", "left/base_link"))]
PREFIXES += [("tf_frame_prefix_enable: false, ", ("odom", "base_link"))]


@pytest.mark.parametrize(("told", "frames"), PREFIXES)
def test_frames_of_a_drive_have_its_prefix_or_its_namespace_in_front(run, friend, tmp_path, told, frames):
    (tmp_path / "cart.urdf").write_text(CART)
    settings = PARAMETERS.replace("left_wheel_names", told + "left_wheel_names")
    (tmp_path / "cart.yaml").write_text(re.sub(r"^(controller_manager|drive):", r"/**/\1:", settings, flags=re.MULTILINE))
    space = ("-r", "__ns:=/r1")
    run("robot_state_publisher", "robot_state_publisher", str(tmp_path / "cart.urdf"), "--ros-args", *space)
    run("controller_manager", "ros2_control_node", "--ros-args", *space, "--params-file", str(tmp_path / "cart.yaml"))
    assert run("controller_manager", "spawner", "drive", "-c", "/r1/controller_manager").wait(20) == 0
    odometry = friend.hear(Odometry, "/r1/drive/odom")
    friend.spin(0.2)
    assert (odometry[-1].header.frame_id, odometry[-1].child_frame_id) == frames
