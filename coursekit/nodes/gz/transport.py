"""The newer Gazebo's own topics: a graph separate from the ROS graph, connected only by bridges.

It is a separate domain on the same bus, so ROS sees nothing of it until it is bridged.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import rclpy
from rclpy.context import Context

if TYPE_CHECKING:
    from rclpy.node import Node

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


@contextmanager
def gz_node(name: str) -> Iterator[Node]:
    """Yield a quiet node in Gazebo's graph; at the end its context is shut down."""
    context = gz_context()
    try:
        yield rclpy.create_node(name, context=context, start_parameter_services=False, enable_rosout=False)
    finally:
        context.try_shutdown()


__all__ = ["APART", "gz_context", "gz_domain", "gz_node"]
