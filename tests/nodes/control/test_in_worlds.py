"""ros2_control in simulated worlds: arms and wheels by the controllers that a robot's files name."""

import pytest
from control_msgs.action import FollowJointTrajectory
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64MultiArray

from tests.nodes.control.conftest import PARAMETERS
from tests.nodes.control.test_arm import send, trajectory
from tests.nodes.gz.conftest import CART, cart, gz, yard  # noqa: F401

PLUGIN = "<gazebo><plugin filename='{}' name='{}'><parameters>{}</parameters></plugin></gazebo>"
CLASSIC = ("gazebo_ros2_control/GazeboSystem", "libgazebo_ros2_control.so", "gazebo_ros2_control")
NEWER = [
    ("gz_ros2_control/GazeboSimSystem", "gz_ros2_control-system", "gz_ros2_control::GazeboSimROS2ControlPlugin"),
    ("ign_ros2_control/IgnitionSystem", "libign_ros2_control-system.so", "ign_ros2_control::IgnitionROS2ControlPlugin"),
]


def moved(friend, run):
    """Spawn the arm's controllers, let it go somewhere; where its joints are then."""
    assert run("controller_manager", "spawner", "joint_state_broadcaster", "arm_controller", "gripper").wait(20) == 0
    states = friend.hear(JointState, "/joint_states")
    goal = FollowJointTrajectory.Goal(trajectory=trajectory(([0.5, 0.4, -0.3, 0, 0, 1.0], 1)))
    result, status = send(friend, FollowJointTrajectory, "/arm_controller/follow_joint_trajectory", goal)
    assert (result.error_code, status) == (0, 4)
    friend.spin(0.5)
    return dict(zip(states[-1].name, states[-1].position, strict=True))


def test_an_arm_moves_in_gazebo_classic(run, friend, files, tmp_path):
    file = tmp_path / "arm.yaml"
    urdf, _ = files(plugin=CLASSIC[0], blocks=PLUGIN.format(*CLASSIC[1:], file))
    run("gazebo_ros", "gzserver")
    assert run("gazebo_ros", "spawn_entity.py", "-file", str(urdf), "-entity", "arm").wait(30) == 0
    at = moved(friend, run)
    assert [at[f"joint{n}"] for n in (1, 2, 3, 6)] == pytest.approx([0.5, 0.4, -0.3, 1.0], abs=0.01)


def test_joints_of_gazebo_classic_may_be_commanded_by_pid_loops(run, friend, files, tmp_path):
    """Since 0.4.8, GazeboSystem exports `position_pid` under the name that controllers claim: `position`."""
    urdf, _ = files(plugin=CLASSIC[0], blocks=PLUGIN.format(*CLASSIC[1:], tmp_path / "arm.yaml"))
    gains = "<param name='pos_kp'>10</param><param name='pos_max_integral_error'>10000</param>"
    looped = gains + "<command_interface name='position_pid'/>"
    urdf.write_text(urdf.read_text().replace("<command_interface name='position'/>", looped))
    run("gazebo_ros", "gzserver")
    assert run("gazebo_ros", "spawn_entity.py", "-file", str(urdf), "-entity", "arm").wait(30) == 0
    at = moved(friend, run)
    assert [at[f"joint{n}"] for n in (1, 2, 3, 6)] == pytest.approx([0.5, 0.4, -0.3, 1.0], abs=0.01)


@pytest.mark.parametrize("names", NEWER)
def test_an_arm_moves_in_the_newer_gazebo_and_its_manager_is_in_ros(run, gz, yard, friend, files, tmp_path, names):  # noqa: F811
    file = tmp_path / "arm.yaml"
    urdf, _ = files(plugin=names[0], blocks=PLUGIN.format(*names[1:], file))
    gz("sim", "-r", yard())
    assert run("ros_gz_sim", "create", "-file", str(urdf), "-name", "arm").wait(30) == 0
    at = moved(friend, run)
    assert [at[f"joint{n}"] for n in (1, 2, 3, 6)] == pytest.approx([0.5, 0.4, -0.3, 1.0], abs=0.01)


def test_the_manager_leaves_with_its_robot(run, friend, files, tmp_path, ros2):
    urdf, _ = files(plugin=CLASSIC[0], blocks=PLUGIN.format(*CLASSIC[1:], tmp_path / "arm.yaml"))
    run("gazebo_ros", "gzserver")
    run("gazebo_ros", "spawn_entity.py", "-file", str(urdf), "-entity", "arm").wait(30)
    assert run("controller_manager", "spawner", "arm_controller").wait(20) == 0
    ros2("service", "call", "/delete_entity", "gazebo_msgs/srv/DeleteEntity", "{name: arm}")
    assert not {"/controller_manager", "/arm_controller"} & set(ros2("node", "list").split())


@pytest.fixture
def wheels(run, friend, tmp_path):
    """A cart whose wheels have these commands; how far it went when its controller was told something."""
    from gazebo_msgs.srv import GetEntityState

    def start(kind, *commands):
        words = "".join(f"<command_interface name='{command}'/>" for command in commands)
        joint = "<joint name='{}_joint'>" + words + "<state_interface name='position'/></joint>"
        blocks = f"<ros2_control name='s' type='system'><hardware><plugin>{CLASSIC[0]}</plugin></hardware>"
        blocks += joint.format("left") + joint.format("right") + "</ros2_control>"
        blocks += PLUGIN.format(*CLASSIC[1:], tmp_path / "wheels.yaml")
        (tmp_path / "wheels.yaml").write_text(
            f"controller_manager: {{ros__parameters: {{wheels: {{type: {kind}}}}}}}\n"
            "wheels: {ros__parameters: {joints: [left_joint, right_joint]}}\n"
        )
        (tmp_path / "cart.urdf").write_text(CART.format(blocks=blocks))
        run("gazebo_ros", "gzserver")
        run("gazebo_ros", "spawn_entity.py", "-file", str(tmp_path / "cart.urdf"), "-entity", "cart").wait(30)
        assert run("controller_manager", "spawner", "wheels").wait(20) == 0
        out = friend.node.create_publisher(Float64MultiArray, "/wheels/commands", 10)
        friend.spin(0.2)

        def tell(*values, seconds=2.0):
            out.publish(Float64MultiArray(data=list(values)))
            friend.spin(seconds)
            return friend.ask(GetEntityState, "/get_entity_state", name="cart").state.pose.position

        return tell

    return start


def test_wheels_that_are_commanded_by_their_speeds_drive_the_robot(wheels):
    tell = wheels("velocity_controllers/JointGroupVelocityController", "velocity")
    assert tell(5.0, 5.0).x == pytest.approx(5.0 * 0.05 * 2.0, rel=0.1)


def test_wheels_whose_speeds_are_kept_by_pid_loops_drive_the_robot(wheels):
    tell = wheels("velocity_controllers/JointGroupVelocityController", "velocity_pid")
    assert tell(5.0, 5.0).x == pytest.approx(5.0 * 0.05 * 2.0, rel=0.1)


def test_wheels_that_are_commanded_by_efforts_push_the_robot(wheels):
    """Two wheels of 5 cm push 3 kg with 0.03 Nm each: 1.2 N, 0.4 m/s^2; without an effort it rolls on."""
    tell = wheels("effort_controllers/JointGroupEffortController", "velocity", "effort")
    first = tell(0.03, 0.03).x
    assert first == pytest.approx(0.5 * 0.4 * 2.0**2, rel=0.1)
    assert tell(0.0, 0.0).x - first == pytest.approx(0.8 * 2.0, rel=0.1)
    assert abs(tell(-0.03, 0.03, seconds=0.5).y) > 0.01


def test_an_unknown_controller_of_a_robot_is_told_when_it_is_spawned(run, friend, files, tmp_path):
    file = tmp_path / "arm.yaml"
    strange = PARAMETERS.replace("joint_trajectory_controller/Joint", "my_own/Joint")
    urdf, _ = files(plugin=CLASSIC[0], blocks=PLUGIN.format(*CLASSIC[1:], file), parameters=strange)
    server = run("gazebo_ros", "gzserver")
    run("gazebo_ros", "spawn_entity.py", "-file", str(urdf), "-entity", "arm").wait(30)
    assert run("controller_manager", "spawner", "arm_controller").wait(20) == 1
    assert "Loader for controller 'arm_controller' (type 'my_own/JointTrajectoryController') not found." in server.output


def test_an_arm_that_moves_is_elsewhere_in_the_world_and_a_scanner_sees_it(run, friend, files, tmp_path):
    from gazebo_msgs.srv import GetEntityState

    from coursekit.geometry.plane import Pose2D
    from coursekit.nodes.gazebo.simulators import simulators
    from coursekit.sim import Lidar

    urdf, _ = files(plugin=CLASSIC[0], blocks=PLUGIN.format(*CLASSIC[1:], tmp_path / "arm.yaml"))
    run("gazebo_ros", "gzserver")
    run("gazebo_ros", "spawn_entity.py", "-file", str(urdf), "-entity", "arm").wait(30)
    simulation = simulators.running(friend.session)[0].simulation
    look = Lidar(beams=1, height=0.1, range_max=9.0)
    assert simulation.scan(look, place=Pose2D(2.0, 0.0, 3.14159))[0] > 1.9, "nothing at that height but its thin column"
    assert run("controller_manager", "spawner", "arm_controller").wait(20) == 0
    goal = FollowJointTrajectory.Goal(trajectory=trajectory(([0, 1.5708, 0, 0, 0, 0], 1)))
    assert send(friend, FollowJointTrajectory, "/arm_controller/follow_joint_trajectory", goal)[1] == 4
    tip = friend.ask(GetEntityState, "/get_entity_state", name="arm::link6").state.pose.position
    assert tip.x == pytest.approx(0.4, abs=0.02), "joint 2 lies down: four links are ahead of it"
    assert simulation.scan(Lidar(beams=1, height=0.2, range_max=9.0), place=Pose2D(2.0, 0.0, 3.14159))[0] < 1.7


def test_after_a_reset_the_arm_stands_as_at_first_and_can_be_moved_again(run, friend, files, tmp_path):
    from std_srvs.srv import Empty

    urdf, _ = files(plugin=CLASSIC[0], blocks=PLUGIN.format(*CLASSIC[1:], tmp_path / "arm.yaml"))
    run("gazebo_ros", "gzserver")
    run("gazebo_ros", "spawn_entity.py", "-file", str(urdf), "-entity", "arm").wait(30)
    assert moved(friend, run)["joint2"] == pytest.approx(0.4, abs=0.01)
    states = friend.hear(JointState, "/joint_states")
    friend.ask(Empty, "/reset_simulation")
    friend.spin(0.5)
    at = dict(zip(states[-1].name, states[-1].position, strict=True))
    assert (at["joint1"], at["joint2"]) == pytest.approx((0.0, 0.2))
    goal = FollowJointTrajectory.Goal(trajectory=trajectory(([0.5] * 6, 1)))
    assert send(friend, FollowJointTrajectory, "/arm_controller/follow_joint_trajectory", goal)[1] == 4


def test_a_robot_with_wheels_an_arm_and_an_inertial_unit_has_all_of_it_at_once(run, friend, tmp_path):
    from geometry_msgs.msg import Twist
    from nav_msgs.msg import Odometry
    from sensor_msgs.msg import Imu

    from tests.nodes.control.test_controllers import FELT

    wheel = "<joint name='{}_joint'><command_interface name='velocity'/><state_interface name='position'/></joint>"
    arm = "<joint name='lift'><command_interface name='position'/><state_interface name='position'/></joint>"
    blocks = "<link name='hand'/><joint name='lift' type='prismatic'><parent link='base_link'/><child link='hand'/>"
    blocks += "<axis xyz='0 0 1'/><limit lower='0' upper='0.3' effort='5' velocity='1'/></joint>"
    blocks += f"<ros2_control name='s' type='system'><hardware><plugin>{CLASSIC[0]}</plugin></hardware>"
    blocks += wheel.format("left") + wheel.format("right") + arm + f"<sensor name='imu'>{FELT}</sensor></ros2_control>"
    (tmp_path / "all.yaml").write_text("""controller_manager:
  ros__parameters:
    base: {type: diff_drive_controller/DiffDriveController}
    arm: {type: joint_trajectory_controller/JointTrajectoryController}
    imu_broadcaster: {type: imu_sensor_broadcaster/IMUSensorBroadcaster}
base: {ros__parameters: {left_wheel_names: [left_joint], right_wheel_names: [right_joint], wheel_separation: 0.22,
       wheel_radius: 0.05, use_stamped_vel: false}}
arm: {ros__parameters: {joints: [lift], command_interfaces: [position], state_interfaces: [position]}}
imu_broadcaster: {ros__parameters: {sensor_name: imu, frame_id: imu_link}}
""")
    (tmp_path / "all.urdf").write_text(CART.format(blocks=blocks + PLUGIN.format(*CLASSIC[1:], tmp_path / "all.yaml")))
    run("gazebo_ros", "gzserver")
    run("gazebo_ros", "spawn_entity.py", "-file", str(tmp_path / "all.urdf"), "-entity", "robot").wait(30)
    assert run("controller_manager", "spawner", "base", "arm", "imu_broadcaster").wait(20) == 0
    odometry, imu = friend.hear(Odometry, "/base/odom"), friend.hear(Imu, "/imu_broadcaster/imu")
    out, twist = friend.node.create_publisher(Twist, "/base/cmd_vel_unstamped", 10), Twist()
    twist.linear.x, twist.angular.z = 0.2, 0.5
    for _ in range(10):
        out.publish(twist)
        friend.spin(0.1)
    assert imu[-1].angular_velocity.z == pytest.approx(0.5, abs=0.05) and imu[-1].header.frame_id == "imu_link"
    goal = FollowJointTrajectory.Goal(trajectory=trajectory(([0.2], 1), joints=["lift"]))
    assert send(friend, FollowJointTrajectory, "/arm/follow_joint_trajectory", goal)[1] == 4
    assert odometry[-1].pose.pose.position.x > 0.1
