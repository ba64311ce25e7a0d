"""diff_drive_controller/DiffDriveController: converts commands to wheel speeds, and wheel speeds to odometry."""

from __future__ import annotations

import math
from typing import Any

from geometry_msgs.msg import Twist, TwistStamped
from nav_msgs.msg import Odometry
from tf2_msgs.msg import TFMessage

from .controller import ControlError, Controller, stamp
from .frames import odometry_frames
from .limiter import SpeedLimiter
from .wheel_odometry import WheelOdometry

DEFAULTS: dict[str, Any] = {
    "left_wheel_names": [],
    "right_wheel_names": [],
    "wheels_per_side": 0,
    "wheel_separation": 0.0,
    "wheel_radius": 0.0,
    "wheel_separation_multiplier": 1.0,
    "left_wheel_radius_multiplier": 1.0,
    "right_wheel_radius_multiplier": 1.0,
    "tf_frame_prefix_enable": True,
    "tf_frame_prefix": "",
    "odom_frame_id": "odom",
    "base_frame_id": "base_link",
    "pose_covariance_diagonal": [0.0] * 6,
    "twist_covariance_diagonal": [0.0] * 6,
    "open_loop": False,
    "position_feedback": True,
    "enable_odom_tf": True,
    "cmd_vel_timeout": 0.5,
    "publish_limited_velocity": False,
    "velocity_rolling_window_size": 10,
    "use_stamped_vel": True,
    "publish_rate": 50.0,
} | {
    f"{axis}.{name}": usual
    for axis in ("linear.x", "angular.z")
    for kind in ("velocity", "acceleration", "jerk")
    for name, usual in ((f"has_{kind}_limits", False), (f"max_{kind}", math.nan), (f"min_{kind}", math.nan))
}
"""All parameters of the controller, with their defaults."""


class DiffDriveController(Controller):
    """Drives two sides of wheels; simulated hardware has its own class, which drives the robot itself."""

    def configure(self) -> None:
        """Read parameters, create topics."""
        self._told = {name: self.parameter(name, usual) for name, usual in DEFAULTS.items()}
        self.left, self.right = self._told["left_wheel_names"], self._told["right_wheel_names"]
        if not self.left or len(self.left) != len(self.right):
            counts = f"left wheels [{len(self.left)}] and the number of right wheels [{len(self.right)}]"
            told = f"The number of {counts} are different"
            raise ControlError(told if self.left or self.right else "Wheel names parameters are empty!")
        self._separation = self.length("wheel_separation") * float(self._told["wheel_separation_multiplier"])
        radius = self.length("wheel_radius")
        self._radii = tuple(radius * float(self._told[f"{side}_wheel_radius_multiplier"]) for side in ("left", "right"))
        self._patience = float(self._told["cmd_vel_timeout"])
        self._feedback = "position" if self._told["position_feedback"] else "velocity"
        self._open_loop = bool(self._told["open_loop"])
        self._limits = self._limiter("linear", "x"), self._limiter("angular", "z")
        stamped = self._told["use_stamped_vel"]
        kind, topic = (TwistStamped, "~/cmd_vel") if stamped else (Twist, "~/cmd_vel_unstamped")
        self.node.create_subscription(kind, topic, self._hear, 10)
        limited = self._told["publish_limited_velocity"]
        self._limited = self.node.create_publisher(TwistStamped, "~/cmd_vel_out", 10) if limited else None
        self._reckoning = self._reckoner()
        self._heard_ns = 0
        self._wish = (0.0, 0.0)
        self._last: list[float] | None = None

    def _limiter(self, kind: str, axis: str) -> SpeedLimiter:
        """Return the limits of one speed; invalid limits are reported and ignored, as on a robot."""
        try:
            return SpeedLimiter(self._told.get, f"{kind}.{axis}")
        except ControlError as error:
            self.log.error(f"Error configuring {kind} speed limiter: {error}")
            return SpeedLimiter(lambda _name, usual: usual, kind)

    def _reckoner(self) -> WheelOdometry:
        frames = odometry_frames(self._told, self.node.get_namespace())
        period_ns = round(1e9 / max(float(self._told["publish_rate"]), 1e-3))
        out = self.node.create_publisher(Odometry, "~/odom", 10)
        tf = self.node.create_publisher(TFMessage, "/tf", 100) if self._told["enable_odom_tf"] else None
        spreads = tuple(self._diagonal(f"{kind}_covariance_diagonal") for kind in ("pose", "twist"))
        window = int(self._told["velocity_rolling_window_size"])
        return WheelOdometry(frames, out, tf, period_ns, spreads=spreads, window=1 if self._open_loop else window)

    def _diagonal(self, name: str) -> list[float]:
        values = [float(number) for number in self._told[name]]
        if len(values) not in (0, 6):
            raise ControlError(f"{name} has {len(values)} numbers; give 6: x, y, z, and the turns about them")
        return values

    def _hear(self, msg: Twist | TwistStamped) -> None:
        twist: Any = getattr(msg, "twist", msg)
        if math.isfinite(twist.linear.x) and math.isfinite(twist.angular.z):
            self._wish, self._heard_ns = (twist.linear.x, twist.angular.z), self._said_at(msg)

    def _said_at(self, msg: Twist | TwistStamped) -> int:
        """Return when a command was given: one that is too old at arrival is ignored."""
        if not isinstance(msg, TwistStamped):
            return self.now_ns
        said_ns = int(msg.header.stamp.sec) * 1_000_000_000 + int(msg.header.stamp.nanosec)
        if not said_ns:
            told = "Received TwistStamped with zero timestamp, setting it to current time"
            self.log.warning(f"{told}, this message will only be shown once", once=True)
        return said_ns or self.now_ns

    def command_names(self) -> list[str]:
        """Return the wheels' velocity commands."""
        return [f"{joint}/velocity" for joint in (*self.left, *self.right)]

    def state_names(self) -> list[str]:
        """Return the joint states used by odometry."""
        return [f"{joint}/{self._feedback}" for joint in (*self.left, *self.right)]

    def deactivate(self) -> None:
        """Stop."""
        self._wish = (0.0, 0.0)
        for name in self.command_names():
            self.interfaces.command(name, 0.0)
        for limit in self._limits:
            limit.restart()

    def update(self, now_ns: int, dt: float) -> None:
        """Command the wheels; publish odometry."""
        if self._patience and (now_ns - self._heard_ns) * 1e-9 > self._patience:
            self._wish = (0.0, 0.0)
        way = (self._wish[0] * dt, self._wish[1] * dt) if self._open_loop else self._rolled(dt)
        self._reckoning.go(now_ns, dt, *way)
        ahead, turn = (limiter.limit(wish, dt) for limiter, wish in zip(self._limits, self._wish, strict=True))
        half = turn * self._separation / 2
        for joints, speed, radius in zip((self.left, self.right), (ahead - half, ahead + half), self._radii, strict=True):
            for joint in joints:
                self.interfaces.command(f"{joint}/velocity", speed / radius)
        self._tell_limited(now_ns, ahead, turn)

    def _tell_limited(self, now_ns: int, ahead: float, turn: float) -> None:
        if self._limited is not None:
            msg = TwistStamped()
            msg.header.stamp = stamp(now_ns)
            msg.twist.linear.x, msg.twist.angular.z = ahead, turn
            self._limited.publish(msg)

    def _rolled(self, dt: float) -> tuple[float, float]:
        """Return the distance and rotation in this step."""
        sides = [
            sum(self.interfaces.state(f"{joint}/{self._feedback}") for joint in joints) / len(joints) * radius
            for joints, radius in zip((self.left, self.right), self._radii, strict=True)
        ]
        if any(map(math.isnan, sides)):
            return 0.0, 0.0
        left, right = (side * dt for side in sides)
        if self._feedback == "position":
            last, self._last = self._last or sides, sides
            left, right = sides[0] - last[0], sides[1] - last[1]
        return (left + right) / 2, (right - left) / self._separation


__all__ = ["DEFAULTS", "DiffDriveController"]
