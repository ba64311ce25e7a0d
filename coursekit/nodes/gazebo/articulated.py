"""Robots with moving links: an arm's shape in the world follows its joints."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from coursekit.geometry.plane import Array
from coursekit.sim.solids import Part
from coursekit.urdf import Robot
from coursekit.urdf.kinematics import Kinematics

from .model_file import ModelFile
from .solids import raised
from .transformed_parts import moved
from .value_parsing import matrix

STEP = 0.02
"""The joint motion below which links are not updated [rad or m]."""


class Articulated:
    """The poses of a robot's links and parts, by the positions of its joints."""

    def __init__(self, robot: Robot, made: ModelFile, floor: float) -> None:
        self._kinematics, self._floor = Kinematics(robot), floor
        self._joints = [name for name, joint in robot.joints.items() if joint.moves and joint.mimic is None]
        self._links = {name: (link.pose, list(link.parts)) for name, link in made.links.items()}
        self._last: dict[str, float] = {}

    def has_moved(self, motors: Mapping[str, float]) -> bool:
        """Whether motorised joints have moved since the last `at`; wheels do not count."""
        return any(abs(motors[name] - self._last.get(name, 0.0)) >= STEP for name in self._joints if name in motors)

    def at(self, motors: Mapping[str, float]) -> tuple[dict[str, Array], tuple[Part, ...]]:
        """Return the frames of the links and all their parts."""
        self._last = {name: motors[name] for name in self._joints if name in motors}
        frames = {name: matrix(pose) for name, pose in self._kinematics.poses(self._last).items()}
        parts = []
        for name, (rest, own) in self._links.items():
            shift = frames[name] @ np.linalg.inv(rest)
            still = np.allclose(shift, np.eye(4), atol=1e-9)
            parts += [raised(part if still else moved(part, shift), -self._floor) for part in own]
        return frames, tuple(parts)


__all__ = ["Articulated"]
