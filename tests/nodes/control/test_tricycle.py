"""A tricycle whose front wheel drives and steers, with hardware that is none."""

import math

import pytest
from ackermann_msgs.msg import AckermannDrive
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from std_srvs.srv import Empty
from tf2_msgs.msg import TFMessage

ROBOT = """<robot name='trike'><link name='base_link'/><link name='fork'/><link name='wheel'/>
<joint name='steering' type='continuous'><parent link='base_link'/><child link='fork'/><axis xyz='0 0 1'/></joint>
<joint name='traction' type='continuous'><parent link='fork'/><child link='wheel'/><axis xyz='0 1 0'/></joint>
<ros2_control name='trike' type='system'><hardware><plugin>mock_components/GenericSystem</plugin>
<param name='calculate_dynamics'>true</param></hardware>
<joint name='traction'><command_interface name='velocity'/><state_interface name='position'/>
<state_interface name='velocity'/></joint>
<joint name='steering'><command_interface name='position'/><state_interface name='position'/></joint>
</ros2_control></robot>"""
FILE = """controller_manager:
  ros__parameters:
    update_rate: 100
    trike: {type: tricycle_controller/TricycleController}
trike:
  ros__parameters:
    traction_joint_name: traction
    steering_joint_name: steering
    wheelbase: 0.5
    wheel_radius: 0.1
    use_stamped_vel: false
    enable_odom_tf: true
    publish_ackermann_command: true
    pose_covariance_diagonal: [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]
    traction: {max_velocity: 8.0}
    steering: {max_position: 1.0, max_velocity: 2.0}
"""


@pytest.fixture
def trike(managed, run):
    managed(ROBOT, FILE)
    assert run("controller_manager", "spawner", "trike").wait(20) == 0


def drive(friend, ahead, turn, seconds=2.0):
    out = friend.node.create_publisher(Twist, "/trike/cmd_vel", 10)
    msg = Twist()
    msg.linear.x, msg.angular.z = ahead, turn
    for _ in range(round(seconds / 0.1)):
        out.publish(msg)
        friend.spin(0.1)


def test_it_drives_a_bend_and_tells_it(trike, friend):
    odometry, tf = friend.hear(Odometry, "/trike/odom"), friend.hear(TFMessage, "/tf")
    commands = friend.hear(AckermannDrive, "/trike/cmd_ackermann")
    drive(friend, 0.5, 0.5)
    assert commands[-1].steering_angle == pytest.approx(math.atan(0.5), abs=1e-6)
    assert commands[-1].speed == pytest.approx(5.0 / math.cos(math.atan(0.5)), rel=1e-3)
    last = odometry[-1]
    assert last.twist.twist.linear.x == pytest.approx(0.5, rel=0.01)
    assert last.twist.twist.angular.z == pytest.approx(0.5, rel=0.01)
    assert last.pose.covariance[::7].tolist() == [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]
    assert tf[-1].transforms[0].child_frame_id == "base_link"


def test_on_the_spot_the_wheel_stands_across_as_far_as_it_may(trike, friend):
    commands = friend.hear(AckermannDrive, "/trike/cmd_ackermann")
    drive(friend, 0.0, 1.0, 0.3)
    assert 0.3 < commands[-1].steering_angle < 0.7, "two radians a second"
    drive(friend, 0.0, 1.0)
    assert commands[-1].steering_angle == pytest.approx(1.0)
    assert commands[-1].speed == pytest.approx(5.0 * math.cos(math.pi / 2 - 1.0), rel=0.01)


def test_it_stops_without_commands_and_its_way_begins_anew(trike, friend):
    odometry = friend.hear(Odometry, "/trike/odom")
    drive(friend, 2.0, 0.0, 1.0)
    assert odometry[-1].twist.twist.linear.x == pytest.approx(0.8), "eight radians a second"
    friend.spin(1.0)
    assert odometry[-1].twist.twist.linear.x == 0.0
    friend.ask(Empty, "/trike/reset_odometry")
    friend.spin(0.1)
    assert odometry[-1].pose.pose.position.x == 0.0
