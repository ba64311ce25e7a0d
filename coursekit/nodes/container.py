"""`ros2 run rclcpp_components component_container`: a container whose components run as processes of their own here."""

from __future__ import annotations

from rclpy.node import Node

from coursekit.nodes.running import run


def main(args: list[str] | None = None) -> int:
    """Be there until Ctrl-C; launch files start the components beside it."""
    return run(lambda: Node("ComponentManager"), args)
