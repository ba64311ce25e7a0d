"""Computes Fibonacci numbers as an action, one a second."""

import time
from typing import Any

from action_tutorials_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.node import Node

from coursekit.nodes.demo_nodes.spinning import spin_demo


class FibonacciActionServer(Node):
    """Serves the action `fibonacci`."""

    def __init__(self) -> None:
        super().__init__("fibonacci_action_server")
        self._server = ActionServer(self, Fibonacci, "fibonacci", self._execute)

    def _execute(self, goal_handle: Any) -> Fibonacci.Result:
        self.get_logger().info("Executing goal...")
        feedback = Fibonacci.Feedback(partial_sequence=[0, 1])
        for at in range(1, goal_handle.request.order):
            numbers = feedback.partial_sequence
            numbers.append(numbers[at] + numbers[at - 1])
            self.get_logger().info(f"Feedback: {numbers}")
            goal_handle.publish_feedback(feedback)
            time.sleep(1)
        goal_handle.succeed()
        return Fibonacci.Result(sequence=feedback.partial_sequence)


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C."""
    spin_demo(FibonacciActionServer, args)
