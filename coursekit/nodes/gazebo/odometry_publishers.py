"""Publishers of robots' poses: by their wheels, or the true ones."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry
from tf2_msgs.msg import TFMessage

from coursekit.geometry.plane import Pose2D

from .devices import OdometryDevice, TruthDevice
from .sensor_publishers import SensorPublisher, heading, pose_at, stamp_of


class OdometryPublisher(SensorPublisher):
    """Simulated odometry; commands arrive on `command_topic`."""

    device: OdometryDevice

    def open(self) -> None:
        device = self.device
        self._out = self.publisher(Odometry, device.topic, 50) if device.publish_odom else None
        self._tf = self.publisher(TFMessage, device.tf_topic, 100) if device.publish_tf else None

    def publish(self, time_ns: int) -> None:
        device, robot = self.device, self.robot
        place = pose_at(self.simulation, robot, time_ns) if device.exact else robot.odometer.place
        forward, left, turn = robot.velocity if device.exact else robot.wheels
        stamp = stamp_of(time_ns)
        if self._tf is not None:
            transform = TransformStamped(child_frame_id=device.base_frame)
            transform.header.stamp, transform.header.frame_id = stamp, device.frame
            transform.transform.translation.x, transform.transform.translation.y = place.x, place.y
            transform.transform.rotation = heading(place.theta)
            self._tf.publish(TFMessage(transforms=[transform]))
        if self._out is not None and self._out.get_subscription_count():
            msg = odometry(place, (forward, left, turn), (0, 0, 0) if device.spreads else device.covariance)
            covariances = msg.pose.covariance, msg.twist.covariance
            for covariance, spread in zip(covariances, device.spreads, strict=False):
                if spread:
                    covariance[:: len(spread) + 1] = spread  # the diagonal
            msg.header.stamp, msg.header.frame_id, msg.child_frame_id = stamp, device.frame, device.base_frame
            self._out.publish(msg)


def odometry(place: Pose2D, speed: tuple[float, float, float], covariance: Iterable[float] = (0, 0, 0)) -> Odometry:
    """Convert a pose and a velocity in the robot's frame to a message without header."""
    msg = Odometry()
    msg.pose.pose.position.x, msg.pose.pose.position.y = place.x, place.y
    msg.pose.pose.orientation = heading(place.theta)
    msg.twist.twist.linear.x, msg.twist.twist.linear.y, msg.twist.twist.angular.z = speed
    x, y, yaw = covariance
    for part in (msg.pose, msg.twist) if x or y or yaw else ():
        numbers = np.zeros(36)
        numbers[[0, 7, 14, 21, 28, 35]] = x, y, 1e12, 1e12, 1e12, yaw
        part.covariance = numbers
    return msg


class TruthPublisher(SensorPublisher):
    """Publishes the ground truth."""

    device: TruthDevice

    def open(self) -> None:
        self._out = self.publisher(Odometry, self.device.topic, 10)

    def publish(self, time_ns: int) -> None:
        if self._out.get_subscription_count():
            msg = odometry(pose_at(self.simulation, self.robot, time_ns), self.robot.velocity)
            msg.header.stamp, msg.header.frame_id = stamp_of(time_ns), self.device.frame
            msg.child_frame_id = self.device.body
            self._out.publish(msg)


__all__ = ["OdometryPublisher", "TruthPublisher", "odometry"]
