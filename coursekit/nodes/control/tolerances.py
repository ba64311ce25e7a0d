"""Tolerances of joints, on the path and at the goal."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from .trajectory import Array
from .trajectory_messages import seconds

if TYPE_CHECKING:
    from control_msgs.action import FollowJointTrajectory


@dataclass
class Tolerances:
    """0 is unlimited; `path` and `goal` for positions, `stopped` for speeds at the goal, `goal_time` [s]."""

    path: Array
    goal: Array
    stopped: Array
    path_speed: Array = field(default_factory=lambda: np.zeros(0))
    goal_time: float = 0.0

    def __post_init__(self) -> None:
        if not len(self.path_speed):
            self.path_speed = np.zeros_like(self.path)

    def on_path(self, error: Array, speed: Array | None) -> bool:
        """Whether the errors on the path are within tolerance."""
        return _within(error, self.path) and (speed is None or _within(speed, self.path_speed))

    def at_goal(self, error: Array, speed: Array | None) -> bool:
        """Whether the errors at the goal are within tolerance."""
        return _within(error, self.goal) and (speed is None or _within(speed, self.stopped))

    def asked(self, goal: FollowJointTrajectory.Goal, joints: Sequence[str]) -> Tolerances:
        """Return a copy with the tolerances of an action goal: 0 leaves a value unchanged, below 0 is unlimited."""
        tolerances = Tolerances(
            self.path.copy(), self.goal.copy(), self.stopped.copy(), self.path_speed.copy(), self.goal_time
        )
        for told, positions, speeds in (
            (goal.path_tolerance, tolerances.path, tolerances.path_speed),
            (goal.goal_tolerance, tolerances.goal, tolerances.stopped),
        ):  # fmt: skip
            for tolerance in told:
                if tolerance.name in joints:
                    place = list(joints).index(tolerance.name)
                    _set(positions, place, tolerance.position)
                    _set(speeds, place, tolerance.velocity)
        time = seconds(goal.goal_time_tolerance)
        tolerances.goal_time = tolerances.goal_time if time == 0 else max(time, 0.0)
        return tolerances


def _set(values: Array, place: int, told: float) -> None:
    if told:
        values[place] = max(told, 0.0)


def _within(error: Array, most: Array) -> bool:
    """Whether errors are within limits; nan is an infinite error."""
    return bool(np.all((most <= 0.0) | (np.abs(error) <= most)))


__all__ = ["Tolerances"]
