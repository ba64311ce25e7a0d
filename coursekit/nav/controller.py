"""Following a path in a local costmap: sampled velocities are simulated and scored, as in DWB."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from coursekit.geometry.plane import wrap
from coursekit.nav.controller_kernels import score, touches
from coursekit.nav.costmap import Costmap
from coursekit.nav.footprint import Footprint
from coursekit.nav.inflation import cost_at

Pose = tuple[float, float, float]
Speeds = tuple[float, float]
"""Forward [m/s] and angular [rad/s] velocity."""


class ControlError(Exception):
    """No valid command; the message gives the reason."""


@dataclass(frozen=True)
class Limits:
    """Velocity limits [m/s, rad/s] and acceleration limits [m/s², rad/s²] of a robot."""

    min_speed: float = 0.0
    max_speed: float = 0.26
    max_turn: float = 1.0
    acceleration: float = 2.5
    deceleration: float = 2.5
    turn_acceleration: float = 3.2

    def toward(self, now: Speeds, wish: Speeds, seconds: float) -> Speeds:
        """Return the velocities after `seconds`, changing from `now` towards `wish`.

        >>> Limits().toward((0.0, 0.0), (0.2, 1.0), 0.04)
        (0.1, 0.128)
        """
        rate = self.acceleration if abs(wish[0]) > abs(now[0]) else self.deceleration
        return _near(now[0], wish[0], rate * seconds), _near(now[1], wish[1], self.turn_acceleration * seconds)


def _near(now: float, wish: float, most: float) -> float:
    return round(now + max(-most, min(most, wish - now)), 9)


@dataclass
class Controller:
    """Drives a robot along a path; all poses are in the frame of the costmap.

    `horizon` is the simulated time [s]. A robot whose heading is off the path by more than `turn_first` [rad] rotates first.
    """

    limits: Limits = field(default_factory=Limits)
    footprint: Footprint = field(default_factory=lambda: Footprint.disc(0.22))
    horizon: float = 1.7
    speeds: int = 20
    turns: int = 20
    turn_first: float = 0.785
    period: float = 0.05
    weights: tuple[float, float, float, float, float, float] = (16.0, 12.0, 16.0, 12.0, 0.02, 0.325)
    scaling: tuple[float, float] = (0.55, 3.0)
    """Radius [m] and factor of the costmap's inflation: they give the lowest cost at which the outline may touch."""
    _turning: bool = False
    _index: int = 0

    def begin(self) -> None:
        """Start a new path: the robot is near its beginning."""
        self._turning, self._index = False, 0

    def command(self, costs: Costmap, pose: Pose, now: Speeds, path: np.ndarray, speed: float = 0.0) -> Speeds:
        """Return the next velocities; ControlError when every trajectory collides. `speed` is a further limit if not 0.

        >>> room = Costmap.of_size(4.0, 4.0, 0.05, -2.0, -2.0)
        >>> way = np.column_stack([np.arange(0, 2, 0.05), np.zeros(40), np.zeros(40)])
        >>> Controller().command(room, (0.0, 0.0, 0.0), (0.2, 0.0), way)
        (0.26, 0.0)
        """
        ahead = self._ahead(pose, path)
        top = min(self.limits.max_speed, speed) if speed > 0 else self.limits.max_speed
        carrot = self._carrot(ahead, max(top * self.horizon, 0.3))
        bearing = wrap(math.atan2(carrot[1] - pose[1], carrot[0] - pose[0]) - pose[2])
        far = math.hypot(carrot[0] - pose[0], carrot[1] - pose[1]) > 0.1
        limit = self.turn_first * (0.4 if self._turning else 1.0)
        held = self.blocked(costs, pose)
        self._turning = far and abs(bearing) > limit and not held
        if self._turning:
            try:
                return self.turn(costs, pose, now, bearing)
            except ControlError:
                pass  # no room to rotate here: perhaps there is while driving
        return self._best(costs, pose, now, ahead, carrot, top, -top if held else min(self.limits.min_speed, top))

    def turn(self, costs: Costmap, pose: Pose, now: Speeds, angle: float) -> Speeds:
        """Return the velocities to rotate the robot in place by `angle` [rad]; ControlError if it would touch something.

        >>> room = Costmap.of_size(4.0, 4.0, 0.05, -2.0, -2.0)
        >>> Controller().turn(room, (0.0, 0.0, 0.0), (0.0, 0.0), 1.57)  # 3.2 rad/s² for 0.05 s
        (0.0, 0.16)
        """
        rate = min(self.limits.max_turn, math.sqrt(2 * 0.6 * self.limits.turn_acceleration * abs(angle)), 3.0 * abs(angle))
        for way in np.linspace(0, min(abs(angle), 0.6), 8)[1:]:
            if self.blocked(costs, (pose[0], pose[1], pose[2] + math.copysign(float(way), angle))):
                if self.blocked(costs, pose):
                    break  # it touches something already: rotating may free it
                raise ControlError("Turning on the spot would touch an obstacle")
        return self.limits.toward(now, (0.0, math.copysign(rate, angle)), self.period)

    def blocked(self, costs: Costmap, pose: Pose) -> bool:
        """Whether the robot would touch something at this pose.

        >>> room = Costmap.of_size(4.0, 4.0, 0.05, -2.0, -2.0)
        >>> room.cells[:, 60] = 254  # a wall at x = 1 m
        >>> box = Footprint.parse("[[0.3, 0.1], [0.3, -0.1], [-0.3, -0.1], [-0.3, 0.1]]")
        >>> room.cells[:, 50:60] = 200  # its inflation
        >>> [Controller(footprint=box).blocked(room, (0.8, 0.0, heading)) for heading in (0.0, 1.57)]
        [True, False]
        """
        cost = touches(costs.cells, costs.x, costs.y, costs.resolution, *pose, self._outline(costs), self._near())
        return bool(cost == 255)

    def _outline(self, costs: Costmap) -> np.ndarray:
        return self.footprint.outline(costs.resolution * 0.7)

    def _near(self) -> int:
        """The lowest cost of the centre at which the outline may touch something."""
        radius, factor = self.scaling
        if self.footprint.circumscribed >= radius:
            return 0
        return max(cost_at(self.footprint.circumscribed + 0.05, self.footprint.inscribed, factor), 0)

    def _ahead(self, pose: Pose, path: np.ndarray) -> np.ndarray:
        """Return the path (n, 2) from the robot's position onwards."""
        gaps = np.hypot(path[:, 0] - pose[0], path[:, 1] - pose[1])
        steps = np.hypot(*np.diff(path[:, :2], axis=0).T) if len(path) > 1 else np.zeros(0)
        gone = np.concatenate([[0.0], np.cumsum(steps)])
        self._index = min(self._index, len(path) - 1)
        onward = gone - gone[self._index]
        near = (onward >= 0) & (onward <= 3.0)  # ignores parts of the path that return here much later
        self._index = int(np.argmin(np.where(near, gaps, np.inf)))
        return np.ascontiguousarray(path[self._index :, :2], dtype=float)

    @staticmethod
    def _carrot(ahead: np.ndarray, reach: float) -> Speeds:
        """Return the point `reach` metres ahead on the path."""
        if len(ahead) < 2:
            return float(ahead[0, 0]), float(ahead[0, 1])
        gone = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(ahead, axis=0).T))])
        index = min(int(np.searchsorted(gone, reach)), len(ahead) - 1)
        return float(ahead[index, 0]), float(ahead[index, 1])

    def _best(
        self, costs: Costmap, pose: Pose, now: Speeds,
        ahead: np.ndarray, carrot: tuple[float, float], top: float, low: float,
    ) -> Speeds:  # fmt: skip
        speeds = np.linspace(low, top, self.speeds)
        turns = np.append(np.linspace(-self.limits.max_turn, self.limits.max_turn, self.turns), 0.0)
        gap = math.hypot(carrot[0] - pose[0], carrot[1] - pose[1])
        ux, uy = ((carrot[0] - pose[0]) / gap, (carrot[1] - pose[1]) / gap) if gap > 1e-3 else (0.0, 0.0)
        target = np.array([*carrot, carrot[0] + ux * self.weights[5], carrot[1] + uy * self.weights[5]])
        path = _extended(ahead, self.weights[5], ux, uy)
        gains = np.array([self.limits.acceleration, self.limits.turn_acceleration])
        scores = score(
            costs.cells, costs.x, costs.y, costs.resolution, self._outline(costs), self._near(), np.array(pose, dtype=float),
            speeds, turns, np.array(now, dtype=float), gains, self.horizon, 0.05, path, target, np.array(self.weights),
        )  # fmt: skip
        a, b = divmod(int(scores.argmin()), len(turns))
        if not math.isfinite(scores[a, b]):
            raise ControlError(f"No valid trajectories out of {scores.size}!")
        return self.limits.toward(now, (float(speeds[a]), float(turns[b])), self.period)


def _extended(path: np.ndarray, by: float, ux: float, uy: float) -> np.ndarray:
    """Return about the next two metres of a path, extended straight at its end."""
    near = path[:80]
    if len(path) > 80:
        return near
    along = np.arange(0.05, by + 0.05, 0.05)[:, None]
    end = near[-1] - near[-2] if len(near) > 1 else np.array([ux, uy])
    size = float(np.hypot(*end))
    return np.vstack([near, near[-1] + along * (end / size if size > 1e-9 else 0.0)])
