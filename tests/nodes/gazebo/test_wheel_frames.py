"""Drives that publish the frames of their wheels (`publish_wheel_tf`), where nobody publishes joint states."""

import math

import pytest
from rclpy.time import Time
from tf2_msgs.msg import TFMessage
from tf2_ros import Buffer, TransformListener

from coursekit.nodes.gazebo.sdf_world import read_entity
from tests.nodes.gz.conftest import CART, cart  # noqa: F401

DRIVE = """<gazebo><plugin name='d' filename='libgazebo_ros_diff_drive.so'>{}<left_joint>left_joint</left_joint>
<right_joint>right_joint</right_joint><wheel_separation>0.22</wheel_separation><wheel_diameter>0.1</wheel_diameter>
<publish_odom_tf>true</publish_odom_tf><publish_wheel_tf>true</publish_wheel_tf></plugin></gazebo>"""


def test_wheels_turn_in_the_tree_of_frames(run, friend, cart):  # noqa: F811
    run("gazebo_ros", "gzserver")
    assert run("gazebo_ros", "spawn_entity.py", "-file", cart(DRIVE.format("")), "-entity", "cart").wait(20) == 0
    buffer = Buffer()
    TransformListener(buffer, friend.node)
    friend.spin(0.5)
    still = buffer.lookup_transform("odom", "left_wheel", Time()).transform
    assert (still.translation.y, still.translation.z) == pytest.approx((0.11, 0.05)) and still.rotation.w == 1.0
    friend.go(1.0, 0.1)
    turned = buffer.lookup_transform("base_footprint", "left_wheel", Time()).transform.rotation
    angle = 2 * math.atan2(turned.y, turned.w) % (2 * math.pi)
    assert angle == pytest.approx(0.1 / 0.05, rel=0.1) and turned.x == pytest.approx(0.0)


def test_they_hang_on_the_link_that_fixed_joints_make_one_as_in_gazebo(run, friend, cart):  # noqa: F811
    run("gazebo_ros", "gzserver")
    ros = "<ros><namespace>r1</namespace><remapping>/tf:=tf</remapping></ros>"
    assert run("gazebo_ros", "spawn_entity.py", "-file", cart(DRIVE.format(ros)), "-entity", "cart").wait(20) == 0
    heard = friend.hear(TFMessage, "/r1/tf")
    friend.spin(0.5)
    pairs = {(transform.header.frame_id, transform.child_frame_id) for msg in heard for transform in msg.transforms}
    assert pairs >= {("base_footprint", "left_wheel"), ("base_footprint", "right_wheel"), ("odom", "base_footprint")}


def test_nothing_is_left_to_tell():
    assert not read_entity(CART.format(blocks=DRIVE.format("")), "", None).notes
