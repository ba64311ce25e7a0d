"""Counts the nodes that a launch starts under each name."""

from __future__ import annotations

from launch.launch_context import LaunchContext

KEY = "unique_ros_node_names"


def add_node_name(context: LaunchContext, node_name: str) -> None:
    """Count a node name."""
    counts = context.get_locals_as_dict().get(KEY)
    if counts is None:
        counts = {}
        context.extend_globals({KEY: counts})
    counts[node_name] = counts.get(node_name, 0) + 1


def get_node_name_count(context: LaunchContext, node_name: str) -> int:
    """Return the number of nodes started under that name."""
    count: int = context.get_locals_as_dict().get(KEY, {}).get(node_name, 0)
    return count
