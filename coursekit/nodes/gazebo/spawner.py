"""`ros2 run controller_manager spawner NAME ...`: waits until the simulated robot has its controllers."""

from __future__ import annotations

import argparse
import sys
from typing import Any

import rclpy
from rclpy.utilities import remove_ros_args


def arguments(argv: list[str], program: str) -> argparse.Namespace:
    """What the command line says; a fault ends the program with status 2."""
    parser = argparse.ArgumentParser(prog=program, description="Start controllers of a simulated robot.")
    parser.add_argument("controller_names", nargs="+", help="names of controllers in the robot's parameter file")
    parser.add_argument("-c", "--controller-manager", default="/controller_manager", help="name of the controller manager")
    parser.add_argument("-p", "--param-file", help="accepted: the robot's description names its parameter file")
    parser.add_argument("-n", "--namespace", default="", help="namespace of the controllers")
    parser.add_argument("-t", "--controller-type", help="accepted: the parameter file tells the type")
    parser.add_argument("--controller-manager-timeout", type=float, default=10.0, help="seconds to wait")
    for name in ("--load-only", "--stopped", "--inactive", "--unload-on-kill", "-u"):
        parser.add_argument(name, action="store_true", help="accepted: controllers are active while their robot is there")
    return parser.parse_args(argv)


def main(args: list[str] | None = None) -> Any:
    """Wait for the controllers; 0, or 1 if they do not come."""
    words = remove_ros_args(args if args is not None else sys.argv)
    told = arguments(words[1:], "spawner")
    space = told.namespace or told.controller_manager.rpartition("/")[0]
    rclpy.init(args=args)
    node = rclpy.create_node(f"spawner_{told.controller_names[0]}", namespace=space)
    own = node.get_namespace().rstrip("/")
    try:
        begun = node.get_clock().now().nanoseconds
        for name in told.controller_names:
            while (name, own or "/") not in node.get_node_names_and_namespaces():
                if node.get_clock().now().nanoseconds - begun > told.controller_manager_timeout * 1e9:
                    there = ", ".join(node.get_node_names())
                    node.get_logger().error(
                        f"Controller '{name}' does not come: no robot was spawned whose gazebo_ros2_control plugin has a "
                        f"parameter file with it. Nodes there are: {there}"
                    )
                    return 1
                rclpy.spin_once(node, timeout_sec=0.1)
            node.get_logger().info(f"Loaded {name}")
            node.get_logger().info(f"Configured and activated {name}")
    except KeyboardInterrupt:
        return 130
    finally:
        rclpy.try_shutdown()
    return 0
