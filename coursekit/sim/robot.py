"""Robots as data (`RobotModel`) and in a simulation (`Robot`)."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

from coursekit.geometry.plane import Pose2D

from .motors import Motors, Reach
from .odometry import EXACT, Drift, Odometer
from .solids import Part, Prism

GRAVITY = 9.81


@dataclass(frozen=True)
class Drive:
    """A robot's drive: `differential` (also skid-steer, with several pairs of wheels), `planar` (omnidirectional), or
    `ackermann` (a car: its command's turn is the angle of the front wheels [rad], at most `max_turn`).

    Speeds [m/s, rad/s] and accelerations [m/s^2, rad/s^2] are limits; after `watchdog` seconds without a command it stops,
    0 for never. `left` and `right` are the joints of its wheels.
    """

    kind: str = "differential"
    max_speed: float = math.inf
    max_turn: float = math.inf
    acceleration: float = 3.0
    turn_acceleration: float = 12.0
    watchdog: float = 0.0
    separation: float = 0.3
    radius: float = 0.05
    left: tuple[str, ...] = ()
    right: tuple[str, ...] = ()
    wheelbase: float = 1.0
    """Of a car: the distance between its rear and front axles [m]."""
    steering: tuple[str, ...] = ()
    """Joints that steer a car's front wheels."""


@dataclass(frozen=True)
class RobotModel:
    """A robot: its collision parts (in its base's frame), mass [kg], drive, and odometry errors.

    >>> RobotModel("cart").drive.kind
    'differential'
    """

    name: str
    parts: tuple[Part, ...] = (Prism(((-0.15, -0.12), (0.15, -0.12), (0.15, 0.12), (-0.15, 0.12)), 0.02, 0.2),)
    mass: float = 3.0
    drive: Drive | None = field(default_factory=Drive)
    drift: Drift = EXACT
    fixed: bool = False
    """Whether it is fixed: a mast with sensors. It may overlap objects, and have no parts."""
    grip: float = 1.0
    """Coefficient of friction between its wheels and the floor."""
    reach: dict[str, Reach] = field(default_factory=dict, hash=False)
    """Limits of the motorized joints."""


class Robot:
    """A robot in a simulation; created by `Simulation.spawn`."""

    def __init__(self, model: RobotModel, name: str, body: Any, seed: int) -> None:
        self.model, self.name, self.body = model, name, body
        self.wheels = (0.0, 0.0, 0.0)
        """The velocity given by its wheels: forward, left, angular."""
        self.target = (0.0, 0.0, 0.0)
        self.commanded_ns: int | None = None
        self.angles: dict[str, float] = {}
        """Rotation of each wheel [rad]."""
        self.motors = Motors(self.angles, model.reach)
        self.odometer = Odometer(model.drift, seed)
        self.contacts: dict[str, int] = {}
        """Its current contacts: the names of objects, with the number of contact points."""
        self.restart()

    def restart(self) -> None:
        """Reset all measurements; the robot does not move."""
        drive = self.model.drive
        self.wheels = self.target = (0.0, 0.0, 0.0)
        self.commanded_ns = None
        self.angles.clear()
        self.angles.update(dict.fromkeys((*drive.left, *drive.right), 0.0) if drive else {})
        self.motors.restart()
        self.odometer.restart()

    @property
    def place(self) -> Pose2D:
        """The true pose."""
        return Pose2D(self.body.position.x, self.body.position.y, self.body.angle)

    @property
    def velocity(self) -> tuple[float, float, float]:
        """The true velocity: forward and left [m/s], angular [rad/s]."""
        x, y = self.body.velocity
        c, s = math.cos(self.body.angle), math.sin(self.body.angle)
        return c * x + s * y, c * y - s * x, self.body.angular_velocity

    def command(self, forward: float, turn: float = 0.0, left: float = 0.0, *, now_ns: int | None = None) -> None:
        """Set the commanded velocity; non-finite commands are ignored, excessive ones are limited.

        >>> from coursekit.sim import Simulation, World
        >>> cart = Simulation(World("plain")).spawn(RobotModel("cart", drive=Drive(max_speed=0.5)))
        >>> cart.command(9.0, turn=0.2)
        >>> cart.target
        (0.5, 0.0, 0.2)
        """
        drive = self.model.drive
        if drive is None or not all(math.isfinite(part) for part in (forward, turn, left)):
            return
        speed = math.hypot(forward, left if drive.kind == "planar" else 0.0)
        share = min(1.0, drive.max_speed / speed) if speed else 1.0
        side = left * share if drive.kind == "planar" else 0.0
        turn = max(-drive.max_turn, min(drive.max_turn, turn))
        if drive.kind == "ackermann":
            self.angles.update(dict.fromkeys(drive.steering, turn))
            turn = forward * share * math.tan(turn) / drive.wheelbase
        self.target = (forward * share, side, turn)
        self.commanded_ns = now_ns

    def before_step(self, dt: float, now_ns: int) -> None:
        """Accelerate the wheels towards the command within their limits, and push the body within their grip."""
        self.motors.step(dt)
        drive = self.model.drive
        if drive is None:
            return
        if drive.watchdog and self.commanded_ns is not None and now_ns - self.commanded_ns > drive.watchdog * 1e9:
            self.target = (0.0, 0.0, 0.0)
        limits = (drive.acceleration, drive.acceleration, drive.turn_acceleration)
        self.wheels = tuple(  # type: ignore[assignment]
            was + max(-most * dt, min(most * dt, goal - was))
            for was, goal, most in zip(self.wheels, self.target, limits, strict=True)
        )
        self._push(dt)
        self.odometer.roll(self.wheels, dt)
        self._turn_wheels(drive, dt)

    def _push(self, dt: float) -> None:
        body, (forward, left, turn) = self.body, self.wheels
        u, w, turning = self.velocity
        if self.target == (0.0, 0.0, 0.0) == self.wheels and not (u or w or turning):
            return
        most = self.model.grip * GRAVITY * dt
        wish = (forward - u, left - w)
        size = math.hypot(*wish)
        share = min(1.0, most / size) if size else 0.0
        along, aside = wish[0] * share, wish[1] * share
        c, s = math.cos(body.angle), math.sin(body.angle)
        vx, vy = body.velocity
        body.velocity = vx + c * along - s * aside, vy + s * along + c * aside
        swing = most * body.mass * 0.15 / body.moment * 2
        body.angular_velocity = turning + max(-swing, min(swing, turn - turning))

    def _turn_wheels(self, drive: Drive, dt: float) -> None:
        forward, _, turn = self.wheels
        half = turn * drive.separation / 2
        for names, speed in ((drive.left, forward - half), (drive.right, forward + half)):
            for name in names:
                self.angles[name] += speed / drive.radius * dt


__all__ = ["GRAVITY", "Drive", "Robot", "RobotModel"]
