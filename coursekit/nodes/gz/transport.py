"""The newer Gazebo's own topics: a graph beside that of ROS, which only bridges join.

It is a domain of its own on the same bus, so that nothing of it is seen in ROS until it is bridged.
"""

from __future__ import annotations

import os

from rclpy.context import Context

APART = 1000
"""Added to the number of the ROS domain; none of those has more than three digits."""


def gz_domain() -> int:
    """The number of the graph that has Gazebo's topics."""
    try:
        return APART + int(os.environ.get("ROS_DOMAIN_ID", "") or 0)
    except ValueError:
        return APART


def gz_context() -> Context:
    """A context in Gazebo's graph; arguments for ROS do not reach it."""
    made = Context()
    made.init([], domain_id=gz_domain())
    return made


__all__ = ["APART", "gz_context", "gz_domain"]
