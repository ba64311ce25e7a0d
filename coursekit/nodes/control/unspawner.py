"""`ros2 run controller_manager unspawner NAME ...`: stops controllers and unloads them."""

from __future__ import annotations

import argparse
import sys
from typing import Any

import rclpy
from rclpy.utilities import remove_ros_args

from .manager_client import Asker, NoManager


def main(args: list[str] | None = None) -> Any:
    """Unload the controllers. Returns the exit code."""
    parser = argparse.ArgumentParser(prog="unspawner", description="Stop controllers and unload them.")
    parser.add_argument("controller_names", nargs="+", help="Names of the controllers")
    parser.add_argument("-c", "--controller-manager", default="/controller_manager", help="Name of the manager's ROS node")
    told = parser.parse_args(remove_ros_args(args if args is not None else sys.argv)[1:])
    rclpy.init(args=args)
    node = rclpy.create_node(f"unspawner_{told.controller_names[0]}")
    manager = told.controller_manager
    asker = Asker(node, manager if manager.startswith("/") else f"{node.get_namespace().rstrip('/')}/{manager}")
    try:
        asker.switch(told.controller_names, [])
        node.get_logger().info("Deactivated controller")
        for name in told.controller_names:
            if not asker.unload(name):
                node.get_logger().info("Failed to unload controller")
                return 1
            node.get_logger().info("Unloaded controller")
        return 0
    except NoManager as error:
        node.get_logger().fatal(str(error))
        return 1
    except KeyboardInterrupt:
        return 130
    finally:
        rclpy.try_shutdown()
