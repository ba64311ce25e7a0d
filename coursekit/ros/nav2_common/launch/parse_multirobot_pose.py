"""The names and start poses of several robots, from the command line of a launch."""

from __future__ import annotations

import sys
from typing import Any

import yaml

AXES = ("x", "y", "z", "roll", "pitch", "yaw")


class ParseMultiRobotPose:
    """What the command line of this launch says about robots, as in `robots:="r1={x: 1.0}; r2={y: 2.0, yaw: 1.57}"`.

    It reads `sys.argv` while the launch file is loaded, so neither defaults of launch arguments nor included files count.

    >>> ParseMultiRobotPose("robots").value()
    {}
    """

    def __init__(self, target_argument: str) -> None:
        begin = f"{target_argument}:="
        self.__text = next((word.removeprefix(begin) for word in sys.argv if word.startswith(begin)), "")

    def value(self) -> dict[str, dict[str, Any]]:
        """Return the pose of each robot; what is not given is 0. Entries without a name are left out. Raises YAMLError."""
        poses = {}
        for entry in self.__text.split(";"):
            name, *rest = (part.strip() for part in entry.split("="))
            if len(rest) == 1:
                poses[name] = yaml.safe_load(rest[0])
                for axis in AXES:
                    poses[name].setdefault(axis, 0.0)
        return poses
