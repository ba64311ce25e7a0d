"""The subscriptions of a filter, which convert its sensors' messages to measurements."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from geometry_msgs.msg import PoseWithCovarianceStamped, Twist, TwistWithCovarianceStamped
from nav_msgs.msg import Odometry
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy
from rclpy.time import Time
from sensor_msgs.msg import Imu
from tf2_ros import TransformException

from coursekit.nav.fusion.estimator import Estimator
from coursekit.nav.fusion.measurement import Measurement
from coursekit.nodes.robot_localization.diagnostics import FilterDiagnostics
from coursekit.nodes.robot_localization.geometry import pose_of
from coursekit.nodes.robot_localization.measurement_conversion import MeasurementConverter
from coursekit.nodes.robot_localization.sources import Source

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

_KINDS: dict[str, Any] = {
    "odom": Odometry, "pose": PoseWithCovarianceStamped, "twist": TwistWithCovarianceStamped, "imu": Imu,
}  # fmt: skip


class FilterSubscriptions:
    """Subscribes to sources. Messages that go back in time, or are not after `deaf_until_ns`, are ignored with a warning."""

    def __init__(
        self, node: Node, preparing: MeasurementConverter, estimator: Estimator, sources: list[Source],
        health: FilterDiagnostics | None,
    ) -> None:  # fmt: skip
        self._node, self._preparing, self._estimator = node, preparing, estimator
        self._last: dict[str, int] = {}
        self.deaf_until_ns, self._health = 0, health
        for source in sources:
            if source.used.any():
                qos = QoSProfile(depth=source.queue_size, reliability=ReliabilityPolicy.BEST_EFFORT)
                node.create_subscription(_KINDS[source.kind], source.topic, self._hearing(source), qos)

    def forget(self) -> None:
        """Reset to the state before the first message."""
        self._last.clear()
        self._preparing.forget()
        self._estimator.forget()

    def _hearing(self, source: Source) -> Callable[[Any], None]:
        take = getattr(self, f"_take_{source.kind}")

        def hear(msg: Odometry | PoseWithCovarianceStamped | TwistWithCovarianceStamped | Imu) -> None:
            stamp = Time.from_msg(msg.header.stamp).nanoseconds
            if self._in_time(source, stamp):
                take(source, stamp, msg)

        return hear

    def _in_time(self, source: Source, stamp_ns: int) -> bool:
        before, self._last[source.name] = self._last.get(source.name, stamp_ns), stamp_ns
        if stamp_ns > self.deaf_until_ns and stamp_ns >= before:
            return True
        self._last[source.name] = before
        if self._node.get_clock().now().nanoseconds <= self.deaf_until_ns:
            return False  # a simulation begins: its first messages have time 0
        late = "equal to or before the last filter reset"
        if stamp_ns < before:
            late = "before that of the previous message received"
        self._warn(
            f"{source.name}_timestamp",
            f"The {source.name} message has a timestamp {late}, this message will be ignored. This may indicate an "
            f"empty or bad timestamp. (message time: {stamp_ns * 1e-9:.6f})",
        )
        return False

    def _warn(self, about: str, text: str) -> None:
        if self._health is not None:
            self._health.complain(about, text)
        self._node.get_logger().warning(text, throttle_duration_sec=5.0)

    def _add(self, source: Source, make: Callable[[], Measurement | None]) -> None:
        """Queue a measurement; warn if a transform for it is missing."""
        try:
            measurement = make()
        except TransformException as fault:
            self._warn(f"{source.name}_transform", f"A message of {source.name} ({source.topic}) cannot be used: {fault}")
            return
        if measurement is not None:
            self._estimator.add(measurement)

    # -- kinds of messages

    def _take_odom(self, source: Source, stamp: int, msg: Odometry) -> None:
        self._take_pose(source, stamp, msg)
        self._twist(source, stamp, msg.child_frame_id, msg.twist.twist, msg.twist.covariance)

    def _take_pose(self, source: Source, stamp: int, msg: Odometry | PoseWithCovarianceStamped) -> None:
        if source.part("pose").any():
            pose = pose_of(msg.pose.pose.position, msg.pose.pose.orientation)
            frame = msg.header.frame_id
            self._add(source, lambda: self._preparing.pose(source, frame, stamp, pose, msg.pose.covariance))

    def _take_twist(self, source: Source, stamp: int, msg: TwistWithCovarianceStamped) -> None:
        self._twist(source, stamp, msg.header.frame_id, msg.twist.twist, msg.twist.covariance)

    def _twist(self, source: Source, stamp: int, frame: str, twist: Twist, covariance: NDArray[np.float64]) -> None:
        if source.part("twist").any():
            state = self._estimator.filter.now.state
            self._add(source, lambda: self._preparing.twist(source, frame, stamp, twist, covariance, state))

    def _take_imu(self, source: Source, stamp: int, msg: Imu) -> None:
        """Add the measurements of an IMU; parts whose first covariance is -1 are not measured."""
        frame, state = msg.header.frame_id, self._estimator.filter.now.state
        if source.part("pose").any() and msg.orientation_covariance[0] != -1:
            q, doubt = msg.orientation, msg.orientation_covariance
            self._add(source, lambda: self._preparing.heading(source, frame, stamp, q, doubt))
        if msg.angular_velocity_covariance[0] != -1:
            twist = TwistWithCovarianceStamped().twist
            twist.twist.angular = msg.angular_velocity
            covariance = twist.covariance.reshape(6, 6)
            covariance[3:, 3:] = msg.angular_velocity_covariance.reshape(3, 3)
            self._twist(source, stamp, frame, twist.twist, covariance.ravel())
        if source.part("acceleration").any() and msg.linear_acceleration_covariance[0] != -1:
            self._add(source, lambda: self._preparing.acceleration(source, frame, stamp, msg, state))
