"""A hidden node of the command's own, for the duration of the command."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

import rclpy
from rclpy.parameter import Parameter

from . import NODE_NAME_PREFIX

if TYPE_CHECKING:
    from argparse import ArgumentParser, Namespace

DEFAULT_TIMEOUT = 0.5
"""Seconds for discovery in ROS 2; here the graph is known at once."""


class DirectNode:
    """Wraps a node `_ros2cli_PID` inside `with`; other attributes are those of the node.

    It spins for `args.spin_time` [s] first. With `args.use_sim_time`, it follows /clock.
    """

    def __init__(self, args: Namespace, *, node_name: str | None = None) -> None:
        self._owns_context = not rclpy.ok()
        if self._owns_context:
            rclpy.init(args=getattr(args, "argv", []))
        simulated = bool(getattr(args, "use_sim_time", False))
        self.node = rclpy.create_node(
            node_name or NODE_NAME_PREFIX + f"_{os.getpid()}",
            start_parameter_services=getattr(args, "start_parameter_services", False),
            parameter_overrides=[Parameter("use_sim_time", value=simulated)],
            automatically_declare_parameters_from_overrides=True,
            use_global_arguments=False,
        )
        seconds = getattr(args, "spin_time", None)
        if seconds:
            rclpy.spin_until_future_complete(self.node, rclpy.Future(), timeout_sec=seconds)

    def __enter__(self) -> DirectNode:
        return self

    def __getattr__(self, name: str) -> Any:
        if name == "node" or (name.startswith("__") and name.endswith("__")):
            raise AttributeError(name)
        return getattr(self.node, name)

    def __exit__(self, *_error: object) -> None:
        self.node.destroy_node()
        if self._owns_context:
            rclpy.try_shutdown()


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options `--spin-time` and `--use-sim-time`."""
    parser.add_argument(
        "--spin-time", type=float, default=DEFAULT_TIMEOUT, help="Spin time in seconds to wait for discovery"
    )
    parser.add_argument("-s", "--use-sim-time", action="store_true", help="Enable ROS simulation time")
