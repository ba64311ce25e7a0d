"""The turtles' world with plain numbers: a square sheet of paper, turtles that move on it, pens that draw.

Metres and radians, the origin bottom left, y up. In ROS 2: turtlesim (500 pixels, 45 per metre).
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field

from coursekit.sim.paper import Paper

SIDE = 11.088889122009277
"""Width and height of the world [m]: 499 / 45 as a 32-bit float, as in turtlesim."""
STEP = 0.016
"""Length of one frame [s]."""
COMMAND_SECONDS = 1.0
"""Timeout of a velocity command [s]."""
NEAR = 0.02
"""A rotation ends within this distance of its goal [rad]."""


def normalize_angle(angle: float) -> float:
    """Wrap an angle to [-pi, pi).

    >>> round(normalize_angle(3 * math.pi / 2), 4)
    -1.5708
    """
    return angle - 2 * math.pi * math.floor((angle + math.pi) / (2 * math.pi))


@dataclass
class Pen:
    """A turtle's pen: colour 0 to 255, width in pixels."""

    r: int = 179
    g: int = 184
    b: int = 255
    width: int = 3
    on: bool = True

    def change(self, r: int, g: int, b: int, width: int, off: bool) -> None:
        """Set the pen as the service set_pen does: lifting keeps the colour, width 0 means 1.

        >>> pen = Pen()
        >>> pen.change(255, 0, 0, width=0, off=False)
        >>> pen.r, pen.width, pen.on
        (255, 1, True)
        """
        self.on = not off
        if self.on:
            self.r, self.g, self.b, self.width = r, g, b, width or 1


@dataclass
class Rotation:
    """A rotation to an absolute heading, at one radian per second."""

    goal: float
    start: float
    remaining: float = 0.0
    delta: float = 0.0
    """Angle from the current heading back to the initial one."""
    reached: bool = False


@dataclass
class Teleport:
    """A teleport that waits for the next frame."""

    x: float = 0.0
    y: float = 0.0
    theta: float = 0.0
    linear: float = 0.0
    relative: bool = False


@dataclass
class Turtle:
    """One turtle: its pose [m, rad], its velocity [m/s, rad/s], and its pen."""

    name: str
    x: float
    y: float
    theta: float
    kind: int = 0
    """Index of its image."""
    pen: Pen = field(default_factory=Pen)
    forward: float = 0.0
    sideways: float = 0.0
    turning: float = 0.0
    commanded_at: float = 0.0
    rotation: Rotation | None = None
    teleports: list[Teleport] = field(default_factory=list)
    travelled: float = 0.0
    """Travelled distance [m]; teleports do not count."""
    colour: tuple[int, int, int] = (255, 255, 255)
    """Red, green and blue under it at the last step; white on blank paper."""

    @property
    def speed(self) -> float:
        """The speed [m/s], never negative."""
        return math.hypot(self.forward, self.sideways)

    def command(self, forward: float, sideways: float, turning: float, now: float) -> None:
        """Set the velocities at time `now` [s]; they hold for COMMAND_SECONDS."""
        self.forward, self.sideways, self.turning, self.commanded_at = forward, sideways, turning, now

    def stop(self) -> None:
        """Stop."""
        self.forward = self.sideways = self.turning = 0.0

    def rotate_to(self, theta: float) -> Rotation:
        """Start a rotation to heading `theta`; it continues in each step until `reached`.

        >>> world = World()
        >>> turtle = world.spawn()
        >>> rotation = turtle.rotate_to(0.5)
        >>> frames = 0
        >>> while not rotation.reached:
        ...     frames += 1
        ...     _ = world.step(now=frames * STEP)
        >>> round(frames * STEP, 1), round(turtle.theta, 1)  # half a second at one radian per second
        (0.5, 0.5)
        """
        self.rotation = Rotation(goal=normalize_angle(theta), start=self.theta)
        return self.rotation

    def step(self, now: float, paper: Paper) -> tuple[float, float] | None:
        """Advance by one frame and draw; if a wall was hit, return the position that the turtle would have had."""
        self._jump(paper)
        self._turn(now)
        if now - self.commanded_at > COMMAND_SECONDS:
            self.stop()
        before = (self.x, self.y)
        hit = self._move()
        self.travelled += math.dist(before, (self.x, self.y))
        self.colour = paper.colour_at(self.x, self.y)
        if self.pen.on and (self.x, self.y) != before:
            self._line(before, paper)
        return hit

    def _line(self, before: tuple[float, float], paper: Paper) -> None:
        pen = self.pen
        paper.line(self.name, before, (self.x, self.y), (pen.r, pen.g, pen.b), pen.width)

    def _jump(self, paper: Paper) -> None:
        teleports, self.teleports = self.teleports, []
        for jump in teleports:
            before = (self.x, self.y)
            if jump.relative:
                self.theta += jump.theta
                self.x += math.cos(self.theta) * jump.linear
                self.y += math.sin(self.theta) * jump.linear
            else:
                self.x, self.y, self.theta = jump.x, min(jump.y, SIDE), jump.theta
            if self.pen.on:
                self._line(before, paper)

    def _turn(self, now: float) -> None:
        rotation = self.rotation
        if rotation is None:
            return
        rotation.remaining = normalize_angle(rotation.goal - self.theta)
        rotation.delta = normalize_angle(rotation.start - self.theta)
        if abs(rotation.remaining) < NEAR:
            rotation.reached, self.rotation = True, None
            self.stop()
        else:
            self.command(0.0, 0.0, math.copysign(1.0, rotation.remaining), now)

    def _move(self) -> tuple[float, float] | None:
        self.theta = normalize_angle(self.theta + self.turning * STEP)
        cos, sin = math.cos(self.theta), math.sin(self.theta)
        x = self.x + (cos * self.forward - sin * self.sideways) * STEP
        y = self.y + (sin * self.forward + cos * self.sideways) * STEP
        self.x, self.y = min(max(x, 0.0), SIDE), min(max(y, 0.0), SIDE)
        return None if (self.x, self.y) == (x, y) else (x, y)


class World:
    """The paper and its turtles.

    >>> world = World()
    >>> turtle = world.spawn()
    >>> turtle.command(2.0, 0.0, 0.0, now=0.0)
    >>> for frame in range(50): _ = world.step(now=frame * STEP)
    >>> f"{turtle.name} x={turtle.x:.3f} y={turtle.y:.3f}"
    'turtle1 x=7.144 y=5.544'
    """

    def __init__(self) -> None:
        self.turtles: dict[str, Turtle] = {}
        self.paper = Paper(SIDE)
        self._count = 0
        self._kinds = 0

    def spawn(
        self, name: str = "", x: float = SIDE / 2, y: float = SIDE / 2, theta: float = 0.0, now: float = 0.0
    ) -> Turtle:
        """Add a turtle; unnamed ones become the next free turtleN. KeyError if the name is taken.

        >>> world = World()
        >>> [world.spawn(name).name for name in ("", "leo", "")]
        ['turtle1', 'leo', 'turtle2']
        """
        if name in self.turtles:
            raise KeyError(name)
        name = name or next(free for free in self._names() if free not in self.turtles)
        self.turtles[name] = Turtle(name, x, y, theta, kind=self._kinds, commanded_at=now)
        self._kinds += 1
        return self.turtles[name]

    def _names(self) -> Iterator[str]:
        while True:
            self._count += 1
            yield f"turtle{self._count}"

    def kill(self, name: str) -> None:
        """Remove a turtle; KeyError for an unknown name."""
        del self.turtles[name]

    def reset(self) -> None:
        """Remove all turtles, clear the paper, and count from turtle1 again."""
        self.turtles.clear()
        self._count = self._kinds = 0
        self.paper.clear()

    def step(self, now: float) -> list[tuple[Turtle, tuple[float, float]]]:
        """Advance all turtles by one frame at time `now` [s]; return those that hit a wall, with positions beyond it."""
        hits = []
        for turtle in sorted(self.turtles.values(), key=lambda turtle: turtle.name):
            hit = turtle.step(now, self.paper)
            if hit is not None:
                hits.append((turtle, hit))
        return hits
