"""`ros2 run imu_filter_madgwick imu_filter_madgwick_node`, `ros2 run imu_complementary_filter complementary_filter_node`."""

from __future__ import annotations

from typing import Any

from geometry_msgs.msg import Quaternion, TransformStamped
from rclpy.node import Node
from rclpy.time import Time
from sensor_msgs.msg import Imu, MagneticField
from tf2_ros import TransformBroadcaster

from coursekit.geometry.pose import rotate
from coursekit.nav.fusion.orientation import NORTHS, Orientation, by_share, steadily
from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.running import run

_COMMON: dict[str, Any] = {
    "fixed_frame": "odom", "reverse_tf": False, "constant_dt": 0.0, "orientation_stddev": 0.0, "publish_debug_topics": False,
}  # fmt: skip
_MADGWICK: dict[str, Any] = {
    **_COMMON, "use_mag": True, "publish_tf": True, "stateless": False, "remove_gravity_vector": False, "world_frame": "enu",
    "gain": 0.1, "zeta": 0.0, "mag_bias_x": 0.0, "mag_bias_y": 0.0, "mag_bias_z": 0.0,
}  # fmt: skip
_COMPLEMENTARY: dict[str, Any] = {
    **_COMMON, "use_mag": False, "publish_tf": False, "gain_acc": 0.01, "gain_mag": 0.01, "bias_alpha": 0.01,
    "do_bias_estimation": True, "do_adaptive_gain": True,
}  # fmt: skip
GRAVITY = 9.81


class ImuFilter(Node):
    """Subscribes to `imu/data_raw` and, with `use_mag`, `imu/mag`; publishes `imu/data` with an orientation, and tf."""

    def __init__(self, name: str, defaults: dict[str, Any]) -> None:
        super().__init__(name)
        self.given = declare(self, defaults)
        self.world = self.given.get("world_frame", "enu")
        if self.world not in NORTHS:
            self.get_logger().error(
                f"The parameter world_frame was set to invalid value '{self.world}'. Valid values are {', '.join(NORTHS)}. "
                "Setting to 'enu'."
            )
            self.world = "enu"
        self.held = self.fresh()
        self._field: tuple[float, float, float] | None = None
        self._last_ns: int | None = None
        self._out = self.create_publisher(Imu, "imu/data", 5)
        self._tf = TransformBroadcaster(self) if self.given["publish_tf"] else None
        self.create_subscription(Imu, "imu/data_raw", self._hear, 5)
        if self.given["use_mag"]:
            self.create_subscription(MagneticField, "imu/mag", self._take_field, 5)

    def fresh(self) -> Orientation:
        """Return a new, unknown orientation."""
        raise NotImplementedError

    def _take_field(self, msg: MagneticField) -> None:
        biases = (self.given.get(f"mag_bias_{axis}", 0.0) for axis in "xyz")
        x, y, z = (getattr(msg.magnetic_field, axis) - bias for axis, bias in zip("xyz", biases, strict=True))
        self._field = (x, y, z)

    def _hear(self, msg: Imu) -> None:
        if self.given["use_mag"] and self._field is None:
            self.get_logger().warning(
                "Still waiting for data on topics imu/data_raw and imu/mag... (without a magnetometer: -p use_mag:=false)",
                throttle_duration_sec=10.0,
            )
            return
        if self.given.get("stateless"):
            self.held = self.fresh()
        q = self.held.step(_numbers(msg.angular_velocity), _numbers(msg.linear_acceleration), self._field, self._step(msg))
        msg.orientation.x, msg.orientation.y, msg.orientation.z, msg.orientation.w = q
        spread = self.given["orientation_stddev"] ** 2
        msg.orientation_covariance = [spread, 0.0, 0.0, 0.0, spread, 0.0, 0.0, 0.0, spread]
        if self.given.get("remove_gravity_vector"):
            up = rotate((-q[0], -q[1], -q[2], q[3]), (0.0, 0.0, GRAVITY * NORTHS[self.world][1]))
            felt = msg.linear_acceleration
            felt.x, felt.y, felt.z = felt.x - up[0], felt.y - up[1], felt.z - up[2]
        self._out.publish(msg)
        if self._tf is not None:
            self._tf.sendTransform(self._turned(msg))

    def _step(self, msg: Imu) -> float:
        """Return the seconds since the last message."""
        now = Time.from_msg(msg.header.stamp).nanoseconds
        last, self._last_ns = self._last_ns, now
        constant: float = self.given["constant_dt"]
        return constant if constant > 0 else max(now - (now if last is None else last), 0) * 1e-9

    def _turned(self, msg: Imu) -> TransformStamped:
        above, below, q = self.given["fixed_frame"], msg.header.frame_id, msg.orientation
        if self.given["reverse_tf"]:  # a new quaternion, because the message has already been published
            above, below, q = below, above, Quaternion(x=-q.x, y=-q.y, z=-q.z, w=q.w)
        transform = TransformStamped(child_frame_id=below)
        transform.header.stamp, transform.header.frame_id, transform.transform.rotation = msg.header.stamp, above, q
        return transform


def _numbers(v: Any) -> tuple[float, float, float]:
    return v.x, v.y, v.z


class MadgwickFilter(ImuFilter):
    """Corrects errors at the constant rate `gain`."""

    def __init__(self) -> None:
        super().__init__("imu_filter_madgwick", _MADGWICK)

    def fresh(self) -> Orientation:
        """Return an orientation that is corrected at a constant rate."""
        return Orientation(steadily(self.given["gain"]), self.world)


class ComplementaryFilter(ImuFilter):
    """Each message corrects a fraction of the error, `gain_acc` or `gain_mag`; assumes no gyroscope bias."""

    def __init__(self) -> None:
        super().__init__("ComplementaryFilterROS", _COMPLEMENTARY)

    def fresh(self) -> Orientation:
        """Return an orientation that is corrected by fractions."""
        return Orientation(by_share(self.given["gain_acc"]), self.world, by_share(self.given["gain_mag"]))


def madgwick(args: list[str] | None = None) -> int:
    """Run the filter until Ctrl-C."""
    return run(MadgwickFilter, args)


def complementary(args: list[str] | None = None) -> int:
    """Run the complementary filter until Ctrl-C."""
    return run(ComplementaryFilter, args)
