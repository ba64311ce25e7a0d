"""The names of the frames in which a drive's odometry is told."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


def odometry_frames(told: Mapping[str, Any], namespace: str) -> tuple[str, str]:
    """Return the odometry frame and the robot's frame, with tf_frame_prefix or the controller's namespace in front.

    >>> odometry_frames({}, "/r1"), odometry_frames({"tf_frame_prefix_enable": False}, "/r1")
    (('r1/odom', 'r1/base_link'), ('odom', 'base_link'))
    >>> odometry_frames({"tf_frame_prefix": "left"}, "/")
    ('left/odom', 'left/base_link')
    """
    prefix = str(told.get("tf_frame_prefix", "") or namespace) if told.get("tf_frame_prefix_enable", True) else ""
    front = f"{prefix.rstrip('/')}/".removeprefix("/")
    return front + str(told.get("odom_frame_id", "odom")), front + str(told.get("base_frame_id", "base_link"))


__all__ = ["odometry_frames"]
