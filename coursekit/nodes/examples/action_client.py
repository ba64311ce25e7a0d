"""Minimal action clients: until the result, or with a cancellation."""

from typing import Any

import rclpy
from action_msgs.msg import GoalStatus
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.node import Node
from rclpy.task import Future

from coursekit.nodes.running import to_the_end


class MinimalActionClient(Node):
    """Requests ten steps of `fibonacci` and ends with the result."""

    def __init__(self) -> None:
        super().__init__("minimal_action_client")
        self._client = ActionClient(self, Fibonacci, "fibonacci")

    def send_goal(self) -> None:
        """Wait for the server and send the goal."""
        self.get_logger().info("Waiting for action server...")
        self._client.wait_for_server()
        self.get_logger().info("Sending goal request...")
        future = self._client.send_goal_async(Fibonacci.Goal(order=10), feedback_callback=self._progressed)
        future.add_done_callback(self._answered)

    def _progressed(self, feedback: Any) -> None:
        self.get_logger().info(f"Received feedback: {feedback.feedback.sequence}")

    def _answered(self, future: Future) -> None:
        goal = future.result()
        if not goal.accepted:
            self.get_logger().info("Goal rejected :(")
            return
        self.get_logger().info("Goal accepted :)")
        self._accepted(goal)

    def _accepted(self, goal: Any) -> None:
        goal.get_result_async().add_done_callback(self._finished)

    def _finished(self, future: Future) -> None:
        answer = future.result()
        if answer.status == GoalStatus.STATUS_SUCCEEDED:
            self.get_logger().info(f"Goal succeeded! Result: {answer.result.sequence}")
        else:
            self.get_logger().info(f"Goal failed with status: {answer.status}")
        rclpy.shutdown()


class CancellingClient(MinimalActionClient):
    """Cancels its goal after two seconds."""

    def _accepted(self, goal: Any) -> None:
        self._goal = goal
        self._timer = self.create_timer(2.0, self._cancel)

    def _cancel(self) -> None:
        self._timer.cancel()
        self.get_logger().info("Canceling goal")
        self._goal.cancel_goal_async().add_done_callback(self._cancelled)

    def _cancelled(self, future: Future) -> None:
        done = bool(future.result().goals_canceling)
        self.get_logger().info("Goal successfully canceled" if done else "Goal failed to cancel")
        rclpy.shutdown()


def _ask(make: type[MinimalActionClient], args: list[str] | None) -> int:
    rclpy.init(args=args)
    node = make()
    with to_the_end():
        node.send_goal()
        rclpy.spin(node)
    return 0


def client(args: list[str] | None = None) -> int:
    """Send a goal and wait for the result."""
    return _ask(MinimalActionClient, args)


def client_cancel(args: list[str] | None = None) -> int:
    """Send a goal and cancel it."""
    return _ask(CancellingClient, args)
