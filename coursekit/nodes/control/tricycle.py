"""tricycle_controller/TricycleController: one front wheel that is both driven and steered, with odometry."""

from __future__ import annotations

import math

from ackermann_msgs.msg import AckermannDrive
from geometry_msgs.msg import Twist, TwistStamped
from nav_msgs.msg import Odometry
from std_srvs.srv import Empty
from tf2_msgs.msg import TFMessage

from .controller import ControlError, Controller
from .wheel_odometry import WheelOdometry

NEARLY, FAR = math.pi / 6, math.pi / 2
"""The maximum angle error of the wheel for full speed, and the error from which it creeps [rad]."""
CREEP = 0.01


class TricycleController(Controller):
    """A driven joint (speed) and a steered joint (position)."""

    def configure(self) -> None:
        """Read parameters, create topics."""
        self._drives, self._steers = (self._named(f"{kind}_joint_name") for kind in ("traction", "steering"))
        self._base, self._radius = self.length("wheelbase"), self.length("wheel_radius")
        self._patience = int(self.parameter("cmd_vel_timeout", 500)) * 1e-3  # in milliseconds
        self._open_loop = bool(self.parameter("open_loop", False))
        self._speed, self._angle = Limits(self, "traction"), Limits(self, "steering")
        kind = TwistStamped if self.parameter("use_stamped_vel", True) else Twist
        self.node.create_subscription(kind, "~/cmd_vel", self._hear, 10)
        self.node.create_service(Empty, "~/reset_odometry", self._reset)
        told = self.parameter("publish_ackermann_command", False)
        self._out = self.node.create_publisher(AckermannDrive, "~/cmd_ackermann", 10) if told else None
        self._reckoning = self._reckoner()
        self._wish, self._heard_ns = (0.0, 0.0), 0

    def _named(self, name: str) -> str:
        value = str(self.parameter(name, ""))
        if not value:
            raise ControlError(f"{name} is empty: name a joint of the description's <ros2_control>")
        return value

    def _reckoner(self) -> WheelOdometry:
        frames = self.parameter("odom_frame_id", "odom"), self.parameter("base_frame_id", "base_link")
        spreads = [
            [float(number) for number in self.parameter(f"{kind}_covariance_diagonal", [0.0] * 6)]
            for kind in ("pose", "twist")
        ]
        if any(len(spread) not in (0, 6) for spread in spreads):
            raise ControlError("pose_covariance_diagonal and twist_covariance_diagonal have 6 numbers each")
        tf = self.node.create_publisher(TFMessage, "/tf", 100) if self.parameter("enable_odom_tf", False) else None
        window = 1 if self._open_loop else int(self.parameter("velocity_rolling_window_size", 10))
        return WheelOdometry(frames, self.node.create_publisher(Odometry, "~/odom", 10), tf, spreads=spreads, window=window)

    def _hear(self, msg: Twist | TwistStamped) -> None:
        twist = msg.twist if isinstance(msg, TwistStamped) else msg
        if math.isfinite(twist.linear.x) and math.isfinite(twist.angular.z):
            self._wish, self._heard_ns = (twist.linear.x, twist.angular.z), self.now_ns

    def _reset(self, _request: Empty.Request, response: Empty.Response) -> Empty.Response:
        self._reckoning.restart()
        return response

    def command_names(self) -> list[str]:
        """Return the wheel's speed and angle commands."""
        return [f"{self._drives}/velocity", f"{self._steers}/position"]

    def state_names(self) -> list[str]:
        """Return the wheel's speed and angle states."""
        return self.command_names()

    def deactivate(self) -> None:
        """Stop; the wheel keeps its steering angle."""
        self._wish = (0.0, 0.0)
        self.interfaces.command(f"{self._drives}/velocity", 0.0)
        self._speed.restart()

    def update(self, now_ns: int, dt: float) -> None:
        """Publish odometry; command the wheel."""
        if (now_ns - self._heard_ns) * 1e-9 > self._patience:
            self._wish = (0.0, 0.0)
        felt, turned = (self.interfaces.state(name) for name in self.state_names())
        self._reckoning.go(now_ns, dt, *(speed * dt for speed in self._way(felt, turned)))
        speed, angle = self._asked()
        speed = self._speed.limit(speed * _share(abs(angle - turned)), dt)
        angle = self._angle.limit(angle, dt)
        for name, value in zip(self.command_names(), (speed, angle), strict=True):
            self.interfaces.command(name, value)
        if self._out is not None:
            self._out.publish(AckermannDrive(speed=speed, steering_angle=angle))

    def _way(self, felt: float, turned: float) -> tuple[float, float]:
        """Return linear and angular velocity."""
        if self._open_loop:
            return self._wish
        if math.isnan(felt) or math.isnan(turned):
            return 0.0, 0.0
        rolled = felt * self._radius
        return rolled * math.cos(turned), rolled * math.sin(turned) / self._base

    def _asked(self) -> tuple[float, float]:
        """Return the wheel's speed [rad/s] and angle for the command; it is perpendicular for a rotation in place."""
        ahead, turn = self._wish
        if not ahead and turn:
            return abs(turn) * self._base / self._radius, math.copysign(math.pi / 2, turn)
        angle = math.atan(turn * self._base / ahead) if ahead and turn else 0.0
        return ahead / (self._radius * math.cos(angle)), angle


def _share(off: float) -> float:
    """Return the fraction of its speed for a wheel with this angle error [rad]."""
    if off > FAR:
        return CREEP
    return 1.0 if off < NEARLY or math.isnan(off) else math.cos(off)


class Limits:
    """Limits of the wheel's speed (`traction`) or angle (`steering`), the same in both directions."""

    def __init__(self, controller: Controller, kind: str) -> None:
        def most(name: str) -> float:
            value = float(controller.parameter(f"{kind}.{name}", math.nan))
            return math.inf if math.isnan(value) else value

        traction = kind == "traction"
        self._most = most("max_velocity" if traction else "max_position")
        self._up = most("max_acceleration" if traction else "max_velocity")
        self._down = most("max_deceleration") if traction else self._up
        self._last = 0.0

    def restart(self) -> None:
        """Reset to standstill."""
        self._last = 0.0

    def limit(self, wish: float, dt: float) -> float:
        """Return the limited value after the last value and `dt` seconds."""
        step = (self._up if abs(wish) >= abs(self._last) else self._down) * dt
        value = max(self._last - step, min(self._last + step, wish)) if math.isfinite(step) else wish
        self._last = max(-self._most, min(self._most, value))
        return self._last


__all__ = ["TricycleController"]
