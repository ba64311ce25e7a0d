"""A robot on the virtual clock whose wheels and IMU tell lies of a known size."""

from __future__ import annotations

import math

import numpy as np
import pytest
import rclpy
from geometry_msgs.msg import PoseWithCovarianceStamped, TransformStamped, TwistWithCovarianceStamped
from nav_msgs.msg import Odometry
from sensor_msgs.msg import Imu
from tf2_ros import Buffer, StaticTransformBroadcaster, TransformListener

from tests.nodes.friend import Friend

TICK = 0.02


class Robot(Friend):
    """Publishes odom, imu, pose and twist, and hears what a filter makes of it."""

    def __init__(self, session):
        super().__init__(session, "robot")
        self._rng = np.random.default_rng(4)
        kinds = {"odom": Odometry, "imu": Imu, "pose": PoseWithCovarianceStamped, "twist": TwistWithCovarianceStamped}
        self.out = {name: self.node.create_publisher(kind, name, 10) for name, kind in kinds.items()}
        self.heard: list[Odometry] = []
        self.node.create_subscription(Odometry, "odometry/filtered", self.heard.append, 50)
        self.buffer = Buffer()
        TransformListener(self.buffer, self.node)
        self.static = StaticTransformBroadcaster(self.node)
        self.truth = self.wheels = (0.0, 0.0, 0.0)

    def mount(self, child, parent="base_link", x=0.0, yaw=0.0):
        """A frame that does not move."""
        msg = TransformStamped()
        msg.header.frame_id, msg.child_frame_id, msg.transform.translation.x = parent, child, x
        msg.transform.rotation.z, msg.transform.rotation.w = math.sin(yaw / 2), math.cos(yaw / 2)
        self.static.sendTransform(msg)

    def header(self, msg, frame):
        msg.header.stamp, msg.header.frame_id = self.node.get_clock().now().to_msg(), frame
        return msg

    def tell_odometry(self, forward, turn, pose=None):
        msg = self.header(Odometry(child_frame_id="base_link"), "odom")
        msg.twist.twist.linear.x, msg.twist.twist.angular.z = forward, turn
        x, y, yaw = pose or self.wheels
        msg.pose.pose.position.x, msg.pose.pose.position.y = x, y
        msg.pose.pose.orientation.z, msg.pose.pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
        msg.pose.covariance = np.diag([0.01] * 6).ravel()
        msg.twist.covariance = np.diag([1e-3] * 5 + [2e-2]).ravel()
        self.out["odom"].publish(msg)

    def tell_imu(self, turn, yaw=0.0, frame="base_link", **felt):
        msg = self.header(Imu(), frame)
        msg.angular_velocity.z = turn
        msg.orientation.z, msg.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
        for axis, value in felt.items():
            setattr(msg.linear_acceleration, axis, value)
        msg.orientation_covariance = msg.linear_acceleration_covariance = np.diag([1e-4] * 3).ravel()
        msg.angular_velocity_covariance = np.diag([2.5e-5] * 3).ravel()
        self.out["imu"].publish(msg)

    def drive(self, seconds, forward=0.4, turn=0.3):
        """Drive; the wheels slip in turns, the gyroscope is good."""
        for _ in range(round(seconds / TICK)):
            self.truth = rolled(self.truth, forward, turn)
            slip = 1.25 * turn + self._rng.normal(0, 0.1)
            self.wheels = rolled(self.wheels, forward, slip)
            self.tell_odometry(forward, slip)
            self.tell_imu(turn + self._rng.normal(0, 0.005))
            self.spin(TICK)

    def where(self):
        """x, y and yaw of the newest estimate."""
        pose = self.heard[-1].pose.pose
        return pose.position.x, pose.position.y, 2 * math.atan2(pose.orientation.z, pose.orientation.w)


def rolled(pose, forward, turn):
    x, y, yaw = pose
    middle = yaw + turn * TICK / 2
    return x + forward * math.cos(middle) * TICK, y + forward * math.sin(middle) * TICK, yaw + turn * TICK


@pytest.fixture
def robot(session):
    new_robot = Robot(session)
    yield new_robot
    rclpy.shutdown(context=new_robot.context)


def mask(*counted):
    """Fifteen booleans as a parameter: mask("vx", "vyaw")."""
    names = ["x", "y", "z", "roll", "pitch", "yaw", "vx", "vy", "vz", "vroll", "vpitch", "vyaw", "ax", "ay", "az"]
    return "[" + ", ".join(str(name in counted).lower() for name in names) + "]"


@pytest.fixture
def start(run, session):
    """start("ekf_node", odom0="odom", odom0_config=mask("vx")) starts a filter with parameters."""

    def begin(node="ekf_node", **parameters):
        words = [word for name, value in parameters.items() for word in ("-p", f"{name}:={value}")]
        process = run("robot_localization", node, "--ros-args", *words)
        session.clock.sleep(0.2)
        return process

    return begin
