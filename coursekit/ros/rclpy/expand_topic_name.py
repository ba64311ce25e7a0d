"""Make a topic name absolute. In ROS 2: rclpy.expand_topic_name."""

from __future__ import annotations

from coursekit.rcl import names


def expand_topic_name(topic_name: str, node_name: str, node_namespace: str) -> str:
    """Return the full name of a node's topic; ValueError for an invalid name.

    >>> expand_topic_name("~/pose", "turtle", "/sim")
    '/sim/turtle/pose'
    """
    try:
        return names.expand(topic_name, node_name, node_namespace)
    except ValueError as error:
        raise ValueError(str(error)) from None
