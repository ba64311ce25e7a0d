"""Keeps parameters for others: any may be set, none need be declared."""

import sys

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class ParameterBlackboard(Node):
    """A node that takes every parameter."""

    def __init__(self) -> None:
        super().__init__(
            "parameter_blackboard",
            allow_undeclared_parameters=True,
            automatically_declare_parameters_from_overrides=True,
        )
        self.get_logger().info(
            f"Parameter blackboard node named '{self.get_fully_qualified_name()}' ready, and serving "
            f"'{len(list(self.services))}' services already!"
        )


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C."""
    rclpy.init(args=args)
    node = ParameterBlackboard()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    except ExternalShutdownException:
        sys.exit(1)
    finally:
        node.destroy_node()
        rclpy.try_shutdown()
