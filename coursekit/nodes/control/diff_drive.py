"""diff_drive_controller/DiffDriveController: commands as wheel speeds, wheel speeds as odometry."""

from __future__ import annotations

import math
from typing import Any

from geometry_msgs.msg import Twist, TwistStamped
from nav_msgs.msg import Odometry
from tf2_msgs.msg import TFMessage

from .controller import ControlError, Controller
from .reckoning import Reckoning

LIMITS = (("linear.x.max_velocity", 0), ("angular.z.max_velocity", 1))


class DiffDriveController(Controller):
    """Two sides of wheels; hardware that is simulated has its own, which drives the robot itself."""

    def configure(self) -> None:
        """Read parameters, open topics."""
        self.left, self.right = self.parameter("left_wheel_names", []), self.parameter("right_wheel_names", [])
        if not self.left or len(self.left) != len(self.right):
            raise ControlError(
                f"The number of left wheels [{len(self.left)}] and of right wheels [{len(self.right)}] are different"
                if self.left else "Wheel names parameters are empty!"
            )  # fmt: skip
        names = ("wheel_separation", "wheel_radius", "wheel_separation_multiplier")
        self._separation, self._radius, factor = (
            float(self.parameter(name, usual)) for name, usual in zip(names, (0.0, 0.0, 1.0), strict=True)
        )
        self._separation *= factor
        if min(self._separation, self._radius) <= 0:
            raise ControlError("wheel_separation and wheel_radius must be more than 0")
        frames = self.parameter("odom_frame_id", "odom"), self.parameter("base_frame_id", "base_link")
        self._patience = float(self.parameter("cmd_vel_timeout", 0.5))
        self._feedback = "position" if self.parameter("position_feedback", True) else "velocity"
        self._most = [float(self.parameter(name, math.inf)) for name, _ in LIMITS]
        period_ns = round(1e9 / max(float(self.parameter("publish_rate", 50.0)), 1e-3))
        stamped = self.parameter("use_stamped_vel", True)
        kind, topic = (TwistStamped, "~/cmd_vel") if stamped else (Twist, "~/cmd_vel_unstamped")
        self.node.create_subscription(kind, topic, self._hear, 10)
        out = self.node.create_publisher(Odometry, "~/odom", 10)
        tf = self.node.create_publisher(TFMessage, "/tf", 100) if self.parameter("enable_odom_tf", True) else None
        self._reckoning = Reckoning(frames, out, tf, period_ns)
        self._heard_ns = 0
        self._wish = (0.0, 0.0)
        self._last: tuple[float, float] | None = None

    def _hear(self, msg: Twist | TwistStamped) -> None:
        twist: Any = getattr(msg, "twist", msg)
        if math.isfinite(twist.linear.x) and math.isfinite(twist.angular.z):
            self._wish, self._heard_ns = (twist.linear.x, twist.angular.z), self.now_ns

    def command_names(self) -> list[str]:
        """Speeds."""
        return [f"{joint}/velocity" for joint in (*self.left, *self.right)]

    def state_names(self) -> list[str]:
        """The joints' values that odometry uses."""
        return [f"{joint}/{self._feedback}" for joint in (*self.left, *self.right)]

    def deactivate(self) -> None:
        """Stop."""
        self._wish = (0.0, 0.0)
        for name in self.command_names():
            self.interfaces.command(name, 0.0)

    def update(self, now_ns: int, dt: float) -> None:
        """Command the wheels; tell the way."""
        if self._patience and (now_ns - self._heard_ns) * 1e-9 > self._patience:
            self._wish = (0.0, 0.0)
        ahead, turn = (max(-most, min(most, wish)) for wish, most in zip(self._wish, self._most, strict=True))
        half = turn * self._separation / 2
        for joints, speed in ((self.left, ahead - half), (self.right, ahead + half)):
            for joint in joints:
                self.interfaces.command(f"{joint}/velocity", speed / self._radius)
        self._reckoning.go(now_ns, dt, *self._rolled(dt))

    def _rolled(self, dt: float) -> tuple[float, float]:
        """How far it went and turned in this step."""
        sides = [
            sum(self.interfaces.state(f"{joint}/{self._feedback}") for joint in joints) / len(joints) * self._radius
            for joints in (self.left, self.right)
        ]
        if any(map(math.isnan, sides)):
            return 0.0, 0.0
        left, right = (one * dt for one in sides)
        if self._feedback == "position":
            last, self._last = self._last or (sides[0], sides[1]), (sides[0], sides[1])
            left, right = sides[0] - last[0], sides[1] - last[1]
        return (left + right) / 2, (right - left) / self._separation


__all__ = ["DiffDriveController"]
