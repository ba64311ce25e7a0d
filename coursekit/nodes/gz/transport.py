"""The newer Gazebo's own topics: a graph separate from the ROS graph, connected only by bridges.

It is a separate domain on the same bus, so ROS sees nothing of it until it is bridged.
"""

from __future__ import annotations

import os

from rclpy.context import Context

APART = 1000
"""Added to the ROS domain ID, which has at most three digits."""


def gz_domain() -> int:
    """Return the domain ID of Gazebo's graph."""
    try:
        return APART + int(os.environ.get("ROS_DOMAIN_ID", "") or 0)
    except ValueError:
        return APART


def gz_context() -> Context:
    """Return a context in Gazebo's graph; ROS arguments do not apply to it."""
    context = Context()
    context.init([], domain_id=gz_domain())
    return context


__all__ = ["APART", "gz_context", "gz_domain"]
