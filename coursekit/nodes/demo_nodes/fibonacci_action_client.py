"""Requests the first Fibonacci numbers and logs the feedback."""

from typing import Any

import rclpy
from action_tutorials_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.node import Node
from rclpy.task import Future

from coursekit.nodes.demo_nodes.spinning import demo

ORDER = 10


class FibonacciActionClient(Node):
    """Sends one goal; ends with its result."""

    def __init__(self) -> None:
        super().__init__("fibonacci_action_client")
        self._client = ActionClient(self, Fibonacci, "fibonacci")

    def send_goal(self, order: int) -> None:
        """Wait for the server and send the goal."""
        self._client.wait_for_server()
        sent = self._client.send_goal_async(Fibonacci.Goal(order=order), feedback_callback=self._hear)
        sent.add_done_callback(self._take_answer)

    def _take_answer(self, future: Future) -> None:
        goal_handle = future.result()
        if not goal_handle.accepted:
            self.get_logger().info("Goal rejected :(")
            rclpy.shutdown()
            return
        self.get_logger().info("Goal accepted :)")
        goal_handle.get_result_async().add_done_callback(self._take_result)

    def _take_result(self, future: Future) -> None:
        self.get_logger().info(f"Result: {future.result().result.sequence}")
        rclpy.shutdown()

    def _hear(self, message: Any) -> None:
        self.get_logger().info(f"Received feedback: {message.feedback.partial_sequence}")


def main(args: list[str] | None = None) -> None:
    """Run until the result arrives."""
    rclpy.init(args=args)
    node = FibonacciActionClient()
    with demo(node):
        node.send_goal(ORDER)
        rclpy.spin(node)
