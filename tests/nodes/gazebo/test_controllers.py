"""Robots that drive by ros2_control: their controllers by name, and what starts them."""

import pytest
from geometry_msgs.msg import Twist, TwistStamped
from nav_msgs.msg import Odometry
from rcl_interfaces.msg import ParameterType
from rcl_interfaces.srv import GetParameters
from sensor_msgs.msg import JointState
from tf2_msgs.msg import TFMessage

from coursekit.nodes.gazebo.sdf_world import read_entity
from coursekit.urdf import UrdfError

WHEEL = """<link name='{0}'><collision><origin rpy='1.5707963 0 0'/><geometry>
<cylinder radius='0.05' length='0.02'/></geometry></collision></link>
<joint name='{0}_joint' type='continuous'><parent link='base_link'/><child link='{0}'/>
<origin xyz='0 {1} 0.05'/><axis xyz='0 1 0'/></joint>"""
ROBOT = """<robot name='cart'><link name='base_link'><collision><origin xyz='0 0 0.1'/><geometry>
<box size='0.3 0.2 0.1'/></geometry></collision></link>{wheels}
<ros2_control name='GazeboSystem' type='system'><hardware><plugin>gazebo_ros2_control/GazeboSystem</plugin></hardware>
{joints}</ros2_control>
<gazebo><plugin filename='libgazebo_ros2_control.so' name='gazebo_ros2_control'><parameters>{file}</parameters></plugin>
</gazebo></robot>"""
CONTROLLED = """<joint name='{}_joint'><command_interface name='velocity'/><state_interface name='position'/>
<state_interface name='velocity'/></joint>"""
PARAMETERS = """controller_manager:
  ros__parameters:
    update_rate: 30
    use_sim_time: true
    diff_cont:
      type: diff_drive_controller/DiffDriveController
    joint_broad:
      type: joint_state_broadcaster/JointStateBroadcaster
diff_cont:
  ros__parameters:
    publish_rate: 40.0
    base_frame_id: base_link
    left_wheel_names: ['left_joint']
    right_wheel_names: ['right_joint']
    wheel_separation: 0.22
    wheel_radius: 0.05
    use_stamped_vel: {stamped}
    linear.x.has_velocity_limits: true
    linear.x.max_velocity: 0.4
    angular.z.max_velocity: 0.1
    pose_covariance_diagonal: [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
"""


@pytest.fixture
def cart(tmp_path):
    def write(parameters=PARAMETERS, stamped="false"):
        file = tmp_path / "controllers.yaml"
        file.write_text(parameters.replace("{stamped}", stamped))
        wheels = WHEEL.format("left", 0.11) + WHEEL.format("right", -0.11)
        robot = tmp_path / "cart.urdf"
        joints = "".join(CONTROLLED.format(side) for side in ("left", "right"))
        robot.write_text(ROBOT.format(wheels=wheels, joints=joints, file=file))
        return robot

    return write


KINDS = [("false", "cmd_vel_unstamped", Twist), ("true", "cmd_vel", TwistStamped)]


@pytest.mark.parametrize(("stamped", "topic", "kind"), KINDS)
def test_a_robot_drives_by_its_controller_s_topic(run, spawn, friend, cart, stamped, topic, kind):
    run("gazebo_ros", "gzserver")
    spawner = run("controller_manager", "spawner", "diff_cont", "joint_broad")
    spawn(file=cart(stamped=stamped), name="cart")
    assert spawner.wait(5.0) == 0 and "Configured and activated joint_broad" in spawner.output
    odometry, joints, tf = (
        friend.hear(Odometry, "/diff_cont/odom"), friend.hear(JointState, "/joint_states"), friend.hear(TFMessage, "/tf")
    )  # fmt: skip
    publisher, message = friend.node.create_publisher(kind, f"/diff_cont/{topic}", 10), kind()
    getattr(message, "twist", message).linear.x = 1.0
    for _ in range(10):
        publisher.publish(message)
        friend.spin(0.2)
    assert odometry[-1].pose.pose.position.x == pytest.approx(0.4 * 2.0, rel=0.15), "its greatest speed"
    assert odometry[-1].pose.covariance[::7].tolist() == [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
    assert (odometry[-1].header.frame_id, odometry[-1].child_frame_id) == ("odom", "base_link")
    assert set(joints[-1].name) == {"left_joint", "right_joint"} and joints[-1].position[0] > 10
    assert tf[-1].transforms[0].child_frame_id == "base_link"
    assert 78 <= len(odometry) <= 82 and 58 <= len(joints) <= 62
    friend.spin(2.0)
    assert odometry[-1].twist.twist.linear.x == 0.0, "without commands it stops"
    told = friend.ask(GetParameters, "/diff_cont/get_parameters", names=["wheel_radius", "open_loop"]).values
    assert (told[0].double_value, told[1].type) == (0.05, ParameterType.PARAMETER_BOOL)


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("['left_joint']", "['none']", "joint [none] not found"),
        ("wheel_radius: 0.05", "wheel_radius: big", "numbers that are none"),
        ("left_wheel_names: ['left_joint']", "", "needs left_wheel_names"),
        ("ros__parameters", "parameters", "is no parameter file"),
        ("update_rate: 30", "update_rate: [", "cannot be read"),
        ("update_rate: 30", "update_rate: often", "has an update_rate of often"),
    ],
)
def test_controllers_that_cannot_work_are_told(cart, old, new, says):
    robot = cart(PARAMETERS.replace(old, new))
    with pytest.raises(UrdfError) as caught:
        read_entity(robot.read_text(), "", robot)
    assert says in str(caught.value)


def test_a_missing_parameter_file_is_told(cart, tmp_path):
    robot = cart()
    (tmp_path / "controllers.yaml").unlink()
    entity = read_entity(robot.read_text(), "", robot)
    assert entity.things and not entity.devices, "the robot is there, and nobody controls it"
    (note,) = entity.notes
    assert "nothing controls its joints" in note and "controllers.yaml" in note


def test_a_controller_works_only_when_it_was_spawned(run, spawn, friend, cart):
    run("gazebo_ros", "gzserver")
    spawn(file=cart(), name="cart")
    joints = friend.hear(JointState, "/joint_states")
    friend.spin(1.0)
    assert not joints
    assert run("controller_manager", "spawner", "joint_broad").wait(5.0) == 0
    friend.spin(1.0)
    assert joints


def test_a_spawner_whose_controller_never_comes_says_so(run):
    spawner = run("controller_manager", "spawner", "diff_cont", "--controller-manager-timeout", "2")
    assert spawner.wait(5.0) == 1 and "Controller manager not available" in spawner.output
