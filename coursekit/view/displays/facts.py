"""The facts of a thing for the viewer's Select tool: names and values as text."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from coursekit.view.scene import Pose, Thing
from coursekit.view.scene_shapes import Points, rotation

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.typing import ArrayLike

Fact = tuple[str, str]
"""(name, value)"""


def point_text(point: Iterable[float]) -> str:
    """Format a point in metres.

    >>> point_text((1.0, -0.001, 0.25))
    '1.00, 0.00, 0.25 m'
    """
    return ", ".join(f"{round(float(number), 2) + 0.0:.2f}" for number in point) + " m"


def pose_facts(pose: Pose) -> list[Fact]:
    """Return position, and orientation as roll, pitch and yaw in degrees.

    >>> pose_facts((0, 0, 0, 0, 0, 1, 0))[1]
    ('Orientation', 'roll 0, pitch 0, yaw 180 deg')
    """
    x, y, z, w = pose[3:]
    roll = math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y))
    pitch = math.asin(max(-1.0, min(1.0, 2 * (w * y - z * x))))
    yaw = math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
    turns = ", ".join(
        f"{name} {round(math.degrees(angle))}" for name, angle in (("roll", roll), ("pitch", pitch), ("yaw", yaw))
    )
    return [("Position", point_text(pose[:3])), ("Orientation", f"{turns} deg")]


def header_facts(msg: object) -> list[Fact]:
    """Return the frame and stamp of a message; empty without a header."""
    header = getattr(msg, "header", None)
    if header is None:
        return []
    stamp = header.stamp
    return [("Frame", header.frame_id), ("Time", f"{stamp.sec}.{stamp.nanosec // 1_000_000:03d} s")]


def local(thing: Thing, point: ArrayLike) -> np.ndarray:
    """Transform a point from the fixed frame to the thing's frame [m]."""
    turn = rotation(np.array(thing.pose[3:]))
    local: np.ndarray = ((np.asarray(point, float) - thing.pose[:3]) @ turn) / thing.scale
    return local


def world(thing: Thing, point: ArrayLike) -> np.ndarray:
    """Transform a point from the thing's frame to the fixed frame [m]."""
    turn = rotation(np.array(thing.pose[3:]))
    world: np.ndarray = (np.asarray(point, float) * thing.scale) @ turn.T + thing.pose[:3]
    return world


def nearest_dot(thing: Thing, here: np.ndarray) -> tuple[int, np.ndarray] | None:
    """Return number and position of the dot nearest to a point in the thing's frame; None if there are no dots."""
    dots = next((shape.points for shape in thing.shapes if isinstance(shape, Points) and len(shape.points)), None)
    if dots is None:
        return None
    number = int(np.argmin(((dots - here) ** 2).sum(axis=1)))
    return number, dots[number]


__all__ = ["Fact", "header_facts", "local", "nearest_dot", "point_text", "pose_facts", "world"]
