"""A timer triggers a guard condition, whose callback ends the program."""

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node

from coursekit.nodes.running import to_the_end


class GuardedNode(Node):
    """Triggers its guard condition after two seconds."""

    def __init__(self) -> None:
        super().__init__("demo_guard_condition")
        self._timer = self.create_timer(2.0, self._rang)
        self._guard = self.create_guard_condition(self._triggered)

    def _rang(self) -> None:
        self._guard.trigger()
        self.get_logger().info("timer callback triggered guard condition")

    def _triggered(self) -> None:
        rclpy.shutdown()
        self.get_logger().info("guard callback called shutdown")


def main(args: list[str] | None = None) -> int:
    """Spin step by step until the guard condition ends the program."""
    rclpy.init(args=args)
    node = GuardedNode()
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    with to_the_end():
        while rclpy.ok():
            node.get_logger().info("waiting for 'spin_once' to finish...")
            executor.spin_once()
            node.get_logger().info("...'spin_once' finished!\n")
    return 0
