"""The topics local_plan and transformed_global_plan: where a controller's command leads, and the path around the robot."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from nav_msgs.msg import Path

from coursekit.nodes.nav2.transform_lookup import path_message

if TYPE_CHECKING:
    from coursekit.geometry.plane import Array, Pose2D
    from coursekit.nodes.nav2.controller_server import ControllerServer

_STEP_S = 0.1
_REACH_M = 3.0
"""How much of the path is shown on either side of the robot."""


class LocalPlan:
    """Publishes both while somebody listens."""

    def __init__(self, server: ControllerServer) -> None:
        self._server = server
        self._plan_out = server.create_lifecycle_publisher(Path, "local_plan", 1)
        self._path_out = server.create_lifecycle_publisher(Path, "transformed_global_plan", 1)

    def tell(
        self, here: Pose2D, velocity: tuple[float, float], horizon: float, points: Array, headings: Callable[[], Array]
    ) -> None:
        """Publish what a velocity [m/s, rad/s] does in `horizon` seconds, and the path: points (n, 2) and headings (n).

        All is in the costmap's frame.
        """
        if self._plan_out.get_subscription_count():
            times: Array = np.arange(0.0, horizon + 1e-9, _STEP_S, dtype=np.float64)
            self._plan_out.publish(self._message(arc(here, velocity, times)))
        if self._path_out.get_subscription_count():
            gaps = np.hypot(points[:, 0] - here.x, points[:, 1] - here.y)
            nearest = int(gaps.argmin())
            far = np.flatnonzero(gaps[nearest:] > _REACH_M)
            end = nearest + int(far[0]) if len(far) else len(points)
            self._path_out.publish(self._message(np.column_stack([points, headings()])[nearest:end]))

    def _message(self, poses: Array) -> Path:
        server = self._server
        return path_message(poses, server.costmap.frame, server.get_clock().now().to_msg())

    def destroy(self) -> None:
        """Destroy the publishers."""
        for publisher in (self._plan_out, self._path_out):
            self._server.destroy_lifecycle_publisher(publisher)


def arc(start: Pose2D, velocity: tuple[float, float], times: Array) -> Array:
    """Return the poses (n, 3) at these times [s] of a robot that keeps its velocity [m/s, rad/s].

    >>> from coursekit.geometry.plane import Pose2D
    >>> arc(Pose2D(1.0, 0.0, 0.0), (0.5, 0.0), np.array([0.0, 2.0])).tolist()
    [[1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]
    >>> arc(Pose2D(), (np.pi / 2, np.pi / 2), np.array([1.0])).round(3).tolist()  # a quarter of a circle of 1 m
    [[1.0, 1.0, 1.571]]
    """
    forward, turn = velocity
    headings = start.theta + turn * times
    if abs(turn) < 1e-6:
        x, y = forward * times * np.cos(start.theta), forward * times * np.sin(start.theta)
    else:
        radius = forward / turn
        x, y = radius * (np.sin(headings) - np.sin(start.theta)), radius * (np.cos(start.theta) - np.cos(headings))
    return np.column_stack([start.x + x, start.y + y, headings])
