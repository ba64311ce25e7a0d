"""rf2o_laser_odometry_node: a simulated robot knows its way from its laser alone."""

import math
from pathlib import Path

import pytest
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rclpy.time import Time
from sensor_msgs.msg import LaserScan
from tf2_ros import Buffer, TransformListener

from coursekit.cli.parser import run as run_cli
from coursekit.geometry.plane import Pose2D
from coursekit.nodes.gazebo.simulators import simulators
from coursekit.nodes.scanning.planar import of_transform, plane, put

URDF = Path(__file__).parents[1] / "robot_localization" / "diff_drive.urdf"


@pytest.fixture
def car(session, run):
    """A robot in the simulator, with a laser and without tf from its wheels."""
    run("gazebo_ros", "gzserver", "robot_world")
    assert run("gazebo_ros", "spawn_entity.py", "-file", str(URDF), "-entity", "car").wait(20) == 0
    run("robot_state_publisher", "robot_state_publisher", str(URDF))
    return simulators.running(session)[0].simulation.robots["car"]


def drive(friend, *legs):
    for forward, turn, seconds in legs:
        msg = Twist()
        msg.linear.x, msg.angular.z = forward, turn
        friend.say("cmd_vel", msg)
        friend.spin(seconds)


def off(place, start, pose):
    """How far and how much a pose, seen from the start, is off the truth."""
    moved = Pose2D(*start).to(Pose2D(*place))
    return moved.distance(pose), abs(moved.theta - pose.theta)


@pytest.mark.slow
def test_it_follows_the_robot_and_tells_tf(session, friend, car):
    argv = ["launch", "rf2o_laser_odometry", "rf2o_laser_odometry.launch.py"]
    launched = session.start(lambda: run_cli(argv), name="ros2", argv=argv[:1])
    buffer = Buffer()
    TransformListener(buffer, friend.node)
    heard, start = friend.hear(Odometry, "/odom_rf2o"), tuple(car.place)
    drive(friend, (0.0, 0.0, 2.0), (0.2, 0.0, 4.0), (0.1, 0.5, 4.0), (0.0, 0.0, 0.5))
    assert heard, launched.output
    last = heard[-1]
    distance, angle = off(car.place, start, plane(last.pose.pose.position, last.pose.pose.orientation))
    assert distance < 0.06 and angle < 0.05
    assert math.hypot(car.place.x - start[0], car.place.y - start[1]) > 0.8
    assert (last.header.frame_id, last.child_frame_id) == ("odom", "base_link")
    assert max(odometry.twist.twist.linear.x for odometry in heard) == pytest.approx(0.2, abs=0.08)
    seat = of_transform(buffer.lookup_transform("odom", "base_link", Time.from_msg(last.header.stamp)))
    assert off(car.place, start, seat)[0] < 0.06


def scan_of_a_room():
    """Four walls, from the middle of a room of 4 by 6 m."""
    msg = LaserScan(angle_min=-math.pi, angle_increment=math.radians(2), angle_max=math.pi - math.radians(2), range_max=10.0)
    msg.header.frame_id = "base_link"
    angles = [msg.angle_min + k * msg.angle_increment for k in range(180)]
    msg.ranges = [min(2.0 / max(abs(math.cos(a)), 1e-9), 3.0 / max(abs(math.sin(a)), 1e-9)) for a in angles]
    return msg


def test_it_begins_where_a_topic_says(run, friend):
    run("rf2o_laser_odometry", "rf2o_laser_odometry_node", "--ros-args", "-p", "init_pose_from_topic:=/truth")
    heard, scan, truth = friend.hear(Odometry, "/odom_rf2o"), scan_of_a_room(), Odometry()
    friend.say("/scan", scan)
    friend.spin(0.5)
    assert not heard
    put(Pose2D(4.0, -1.0, 1.0), truth.pose.pose.position, truth.pose.pose.orientation)
    friend.say("/truth", truth)
    friend.spin(0.2)
    for _ in range(3):
        scan.header.stamp = friend.node.get_clock().now().to_msg()
        friend.say("/scan", scan)
        friend.spin(0.2)
    pose = plane(heard[-1].pose.pose.position, heard[-1].pose.pose.orientation)
    assert tuple(pose) == pytest.approx((4.0, -1.0, 1.0), abs=0.01) and abs(heard[-1].twist.twist.linear.x) < 0.05


def test_a_rate_that_is_none_ends_it(run):
    process = run("rf2o_laser_odometry", "rf2o_laser_odometry_node", "--ros-args", "-p", "freq:=0.0")
    assert process.wait(10) != 0 and "freq is 0.0" in process.output
