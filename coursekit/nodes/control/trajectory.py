"""Joint trajectories: points in time, and interpolation between them."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.polynomial import polynomial
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Point:
    """The desired joint states `time` seconds after the start; None for unspecified values."""

    time: float
    positions: Array
    velocities: Array | None = None
    accelerations: Array | None = None


def between(one: Point, other: Point, time: float) -> Point:
    """Interpolate the joints between two points, as smoothly as both points specify.

    Positions alone give a line, velocities a cubic, accelerations a quintic polynomial, as in
    joint_trajectory_controller.

    >>> between(Point(0.0, np.zeros(1)), Point(2.0, np.ones(1)), 0.5).positions
    array([0.25])
    """
    span = other.time - one.time
    past = min(max(time - one.time, 0.0), span)
    curve = _curve(one, other, span)
    if span <= 0.0:
        return Point(time, other.positions, other.velocities, other.accelerations)
    place, speed, push = (np.asarray(polynomial.polyval(past, polynomial.polyder(curve, order))) for order in range(3))
    return Point(time, place, speed, push)


def _curve(one: Point, other: Point, span: float) -> Array:
    """Return coefficients, lowest first, one column for each joint."""
    count = 1
    if one.velocities is not None and other.velocities is not None:
        count = 3 if one.accelerations is not None and other.accelerations is not None else 2
    rows, values = [], []
    for at, point in ((0.0, one), (span, other)):
        for order, value in enumerate((point.positions, point.velocities, point.accelerations)[:count]):
            rows.append([_derivative(power, order, at) for power in range(2 * count)])
            values.append(value)
    if span <= 0.0:
        return np.zeros((2 * count, len(one.positions)))
    return np.asarray(np.linalg.solve(np.array(rows), np.array(values, float)))


def _derivative(power: int, order: int, at: float) -> float:
    """Return the value of a power's derivative."""
    if power < order:
        return 0.0
    factor = 1.0
    for exponent in range(power, power - order, -1):
        factor *= exponent
    return factor * float(at ** (power - order))


@dataclass
class Trajectory:
    """Points to pass from `start_ns` on; before the first one, from the joints' states at `begin`."""

    points: list[Point]
    start_ns: int
    before: Point
    begin_ns: int
    splines: bool = True
    names: tuple[str, ...] = field(default=())

    @property
    def end_ns(self) -> int:
        """Return the end time."""
        return self.start_ns + round(self.points[-1].time * 1e9)

    def sample(self, now_ns: int) -> tuple[Point, bool]:
        """Return the desired joint states, and whether the last point is reached."""
        time = (now_ns - self.start_ns) * 1e-9
        last = self.points[-1]
        if time >= last.time:
            zeros = np.zeros_like(last.positions)
            done = Point(last.time, last.positions, _or(last.velocities, zeros), _or(last.accelerations, zeros))
            return done, True
        begin = (self.begin_ns - self.start_ns) * 1e-9
        before = Point(begin, self.before.positions, self.before.velocities, self.before.accelerations)
        previous = before
        for other in self.points:
            if time < other.time:
                break
            previous = other
        if not self.splines:
            return (before if previous is before else other), False
        return between(previous, other, time), False


def _or(told: Array | None, usual: Array) -> Array:
    return usual if told is None else told


__all__ = ["Array", "Point", "Trajectory", "between"]
