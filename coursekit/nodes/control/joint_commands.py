"""The commands of joints that follow a trajectory: the desired state itself, or a controller of the error."""

from __future__ import annotations

import math

import numpy as np

from .controller import Interfaces
from .pid import Pid
from .trajectory import Point
from .trajectory_parameters import TrajectoryParameters


class JointCommands:
    """The commands of a trajectory's joints; velocities or efforts alone are controlled in a closed loop."""

    def __init__(self, told: TrajectoryParameters) -> None:
        self._told = told
        self._closed = told.commands in (("velocity",), ("effort",))
        self._loops = [Pid(gains) for gains in told.gains]

    def give(self, interfaces: Interfaces, desired: Point, error: Point, dt: float) -> None:
        """Command all joints of a step."""
        for place, joint in enumerate(self._told.command_joints):
            for kind in self._told.commands:
                interfaces.command(f"{joint}/{kind}", self._value(place, kind, desired, error, dt))

    def _value(self, place: int, kind: str, desired: Point, error: Point, dt: float) -> float:
        speed = 0.0 if desired.velocities is None else float(desired.velocities[place])
        if kind == "position":
            return float(desired.positions[place])
        if self._closed:
            rate = 0.0 if error.velocities is None else float(error.velocities[place])
            added = self._loops[place].command(float(error.positions[place]), dt, rate)
            return speed * self._told.feedforward[place] + added
        if kind == "velocity":
            return speed
        return 0.0 if desired.accelerations is None or kind == "effort" else float(desired.accelerations[place])


def difference(desired: Point, actual: Point) -> Point:
    """Return desired minus actual state; angles by the shorter rotation."""
    off = np.array([math.remainder(float(difference), 2 * math.pi) for difference in desired.positions - actual.positions])
    speeds = None if desired.velocities is None or actual.velocities is None else desired.velocities - actual.velocities
    return Point(0.0, off, speeds)


__all__ = ["JointCommands", "difference"]
