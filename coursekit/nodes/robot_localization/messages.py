"""A filter's estimate as messages."""

from __future__ import annotations

from typing import TYPE_CHECKING

from geometry_msgs.msg import AccelWithCovarianceStamped, Point, TransformStamped, Vector3
from nav_msgs.msg import Odometry
from rclpy.time import Time

from coursekit.geometry.pose import Pose
from coursekit.nav.fusion.kalman import Estimate
from coursekit.nav.fusion.state import ACCELERATION, ANGLES, ANGULAR, LINEAR, POSE, POSITION, TWIST
from coursekit.nodes.robot_localization.geometry import quaternion

if TYPE_CHECKING:
    from collections.abc import Iterable


def _put(target: Point | Vector3, numbers: Iterable[float]) -> None:
    target.x, target.y, target.z = (float(number) for number in numbers)


def pose_of(estimate: Estimate) -> Pose:
    """The pose as a tuple."""
    x, y, z = (float(number) for number in estimate.state[POSITION])
    return (x, y, z, *quaternion(estimate.state[ANGLES]))


def odometry(estimate: Estimate, frame: str, child: str) -> Odometry:
    """Pose and twist with their covariances."""
    msg, pose = Odometry(), pose_of(estimate)
    msg.header.stamp = Time(nanoseconds=estimate.time_ns).to_msg()
    msg.header.frame_id, msg.child_frame_id = frame, child
    _put(msg.pose.pose.position, pose[:3])
    q = msg.pose.pose.orientation
    q.x, q.y, q.z, q.w = pose[3:]
    _put(msg.twist.twist.linear, estimate.state[LINEAR])
    _put(msg.twist.twist.angular, estimate.state[ANGULAR])
    msg.pose.covariance = estimate.covariance[POSE, POSE].ravel()
    msg.twist.covariance = estimate.covariance[TWIST, TWIST].ravel()
    return msg


def acceleration(estimate: Estimate, frame: str) -> AccelWithCovarianceStamped:
    """The accelerations with their covariance."""
    msg = AccelWithCovarianceStamped()
    msg.header.stamp, msg.header.frame_id = Time(nanoseconds=estimate.time_ns).to_msg(), frame
    _put(msg.accel.accel.linear, estimate.state[ACCELERATION])
    covariance = msg.accel.covariance.reshape(6, 6)
    covariance[:3, :3] = estimate.covariance[ACCELERATION, ACCELERATION]
    msg.accel.covariance = covariance.ravel()
    return msg


def transform(pose: Pose, stamp_ns: int, frame: str, child: str) -> TransformStamped:
    """A pose as a transform."""
    msg = TransformStamped()
    msg.header.stamp = Time(nanoseconds=stamp_ns).to_msg()
    msg.header.frame_id, msg.child_frame_id = frame, child
    _put(msg.transform.translation, pose[:3])
    q = msg.transform.rotation
    q.x, q.y, q.z, q.w = pose[3:]
    return msg
