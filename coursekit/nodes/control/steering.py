"""The steering controllers: commands become speeds of driven wheels and angles of steered ones; odometry uses both."""

from __future__ import annotations

import math
from typing import Any

from geometry_msgs.msg import Twist, TwistStamped
from nav_msgs.msg import Odometry
from tf2_msgs.msg import TFMessage

from .controller import ControlError, Controller
from .wheel_odometry import WheelOdometry


class SteeringController(Controller):
    """A driven and a steered axle; each with a wheel in the middle, or with a right and a left one.

    A subclass sets the names of its length parameters, and the number of wheels on each axle. Right comes first, as
    in Humble.
    """

    chainable = True
    lengths: tuple[str, ...] = ()
    driven = steered = 2

    def configure(self) -> None:
        """Read parameters, create topics."""
        front = bool(self.parameter("front_steering", True))
        wheels = {end: self.parameter(f"{end}_wheels_names", []) for end in ("rear", "front")}
        felt = {end: self.parameter(f"{end}_wheels_state_names", []) or wheels[end] for end in wheels}
        drives, steers = ("rear", "front") if front else ("front", "rear")
        self.drives, self.steers = self._wheels(wheels, drives, self.driven), self._wheels(wheels, steers, self.steered)
        self._felt = felt[drives], felt[steers]
        self._measure(drives, steers)
        self._kind = "position" if self.parameter("position_feedback", False) else "velocity"
        self._open_loop = bool(self.parameter("open_loop", False))
        self._patience = float(self.parameter("reference_timeout", 1.0))
        stamped = self.parameter("use_stamped_vel", True)
        kind, topic = (TwistStamped, "~/reference") if stamped else (Twist, "~/reference_unstamped")
        self.node.create_subscription(kind, topic, self._hear, 10)
        self._reckoning = self._reckoner()
        self.references = {f"{self.node.get_name()}/{name}": math.nan for name in ("linear/velocity", "angular/position")}
        self._wish, self._angle, self._heard_ns = (0.0, 0.0), 0.0, 0
        self._last: list[float] | None = None

    def _reckoner(self) -> WheelOdometry:
        frames = self.parameter("odom_frame_id", "odom"), self.parameter("base_frame_id", "base_link")
        tf = self.node.create_publisher(TFMessage, "~/tf_odometry", 10) if self.parameter("enable_odom_tf", True) else None
        return WheelOdometry(frames, self.node.create_publisher(Odometry, "~/odometry", 10), tf)

    def _wheels(self, wheels: dict[str, list[str]], end: str, count: int) -> list[str]:
        if len(wheels[end]) != count:
            words = "one joint" if count == 1 else "two joints, the right one first"
            raise ControlError(f"{end}_wheels_names has {len(wheels[end])} names; name {words}")
        return wheels[end]

    def _measure(self, drives: str, steers: str) -> None:
        told = {name: float(self.parameter(name, 0.0)) for name in self.lengths}
        if min(told.values()) <= 0:
            wrong = ", ".join(name for name, value in told.items() if value <= 0)
            raise ControlError(f"{wrong} must be more than 0: give metres")
        self._base = told["wheelbase"]
        self._radius = told.get(f"{drives}_wheels_radius") or told[f"{drives}_wheel_radius"]
        middle = told.get("wheel_track", 0.0)
        self._track = told.get(f"{drives}_wheel_track", middle), told.get(f"{steers}_wheel_track", middle)

    def _hear(self, msg: Twist | TwistStamped) -> None:
        twist = msg.twist if isinstance(msg, TwistStamped) else msg
        if math.isfinite(twist.linear.x) and math.isfinite(twist.angular.z):
            self._wish, self._heard_ns = (twist.linear.x, twist.angular.z), self.now_ns

    def command_names(self) -> list[str]:
        """Return speeds of driven wheels, angles of steered ones."""
        return [*(f"{joint}/velocity" for joint in self.drives), *(f"{joint}/position" for joint in self.steers)]

    def state_names(self) -> list[str]:
        """Return the states used by odometry."""
        return [*(f"{joint}/{self._kind}" for joint in self._felt[0]), *(f"{joint}/position" for joint in self._felt[1])]

    def deactivate(self) -> None:
        """Stop; the wheels keep their steering angle."""
        self._wish = (0.0, 0.0)
        for joint in self.drives:
            self.interfaces.command(f"{joint}/velocity", 0.0)

    def update(self, now_ns: int, dt: float) -> None:
        """Command the wheels; publish odometry."""
        wish = self._wish_at(now_ns)
        ahead, turn = wish or (0.0, 0.0)
        if wish:  # without commands the wheels keep their steering angle
            self._angle = math.atan(turn * self._base / ahead) if ahead and turn else 0.0
        self._command(ahead / self._radius, self._angle)
        bend = math.tan(self._angle) / self._base
        way = (ahead * dt, ahead * bend * dt) if self._open_loop else self._rolled(dt)
        self._reckoning.go(now_ns, dt, *way)

    def _wish_at(self, now_ns: int) -> tuple[float, float] | None:
        """Return the speed and rotation that another controller, or else the topic, commands; None if nobody does."""
        if self.chained:
            ahead, turn = self.references.values()
            return (ahead, turn) if math.isfinite(ahead) and math.isfinite(turn) else None
        late = self._patience and (now_ns - self._heard_ns) * 1e-9 > self._patience
        return None if late else self._wish

    def _command(self, speed: float, angle: float) -> None:
        """Command the wheels: all rotate about one point, on the line of the unsteered axle."""
        bend = math.tan(angle) / self._base
        for joint, side in zip(self.drives, _sides(self.drives), strict=True):
            self.interfaces.command(f"{joint}/velocity", speed * (1 + side * bend * self._track[0] / 2))
        for joint, side in zip(self.steers, _sides(self.steers), strict=True):
            own = math.atan2(self._base * bend, 1 + side * bend * self._track[1] / 2)
            self.interfaces.command(f"{joint}/position", own)

    def _rolled(self, dt: float) -> tuple[float, float]:
        """Return the distance and rotation in this step."""
        wheels = [self.interfaces.state(f"{joint}/{self._kind}") for joint in self._felt[0]]
        angles = [self.interfaces.state(f"{joint}/position") for joint in self._felt[1]]
        if any(map(math.isnan, (*wheels, *angles))):
            return 0.0, 0.0
        turned = [wheel * dt for wheel in wheels]
        if self._kind == "position":
            turned = [wheel - before for wheel, before in zip(wheels, self._last or wheels, strict=True)]
            self._last = wheels
        way = sum(turned) / len(turned) * self._radius
        return way, way * sum(map(self._bend, angles, _sides(angles))) / len(angles)

    def _bend(self, angle: float, side: int) -> float:
        """Return the curvature of the robot's path for a steered wheel at this angle [1/m]."""
        slope = math.tan(angle)
        return slope / (self._base - side * slope * self._track[1] / 2)


def _sides(wheels: list[Any]) -> tuple[int, ...]:
    """Return 1 for a wheel on the right, -1 on the left, 0 in the middle."""
    return (1, -1) if len(wheels) == 2 else (0,)


class AckermannSteeringController(SteeringController):
    """A car: two wheels on each axle."""

    lengths = ("wheelbase", "front_wheel_track", "rear_wheel_track", "front_wheels_radius", "rear_wheels_radius")


class BicycleSteeringController(SteeringController):
    """One wheel on each axle."""

    lengths = ("wheelbase", "front_wheel_radius", "rear_wheel_radius")
    driven = steered = 1


class TricycleSteeringController(SteeringController):
    """Two driven wheels, one steered wheel."""

    lengths = ("wheelbase", "wheel_track", "front_wheels_radius", "rear_wheels_radius")
    steered = 1


__all__ = ["AckermannSteeringController", "BicycleSteeringController", "TricycleSteeringController"]
