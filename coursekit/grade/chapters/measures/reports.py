"""The reports of the robots of chapter 7."""

from __future__ import annotations

import itertools
import math
from typing import Any

from coursekit.grade.outputs import heard
from coursekit.grade.plain import field, fields
from coursekit.grade.trial import Seen

Spot = tuple[float, float, float]
"""x and y [m] and heading [rad]."""
Report = tuple[int, Spot]
"""A stage, and the robot's pose."""


def reports(seen: Seen, number: int) -> list[Report]:
    """Return the reports of a robot, as stage and pose, in order."""
    topic = f"/robot{number}/robot_status"
    told = (message for _, message in heard(seen, topic))
    return [(field(message, "task_stage", int, topic), spot_of(field(message, "pose", dict, topic))) for message in told]


def spot_of(pose: Any) -> Spot:
    """Return the pose in a message; Wrong when it is none."""
    x, y, theta = fields(pose, ("x", "y", "theta"), "a pose")
    return x, y, theta


def carried(told: list[Report]) -> list[float]:
    """Return the distance over which each load was carried [m]."""
    carried: list[float] = []
    picked: Spot | None = None
    for (old, _), (new, place) in itertools.pairwise(told):
        if (old, new) == (2, 3):
            picked = place
        elif (old, new) == (4, 5) and picked is not None:
            carried.append(math.dist(picked[:2], place[:2]))
    return carried
