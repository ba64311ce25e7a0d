"""The action tutorial with the output of its C++ nodes."""

import time
from typing import Any

import rclpy
from action_tutorials_interfaces.action import Fibonacci
from rclpy.action import ActionClient, CancelResponse, GoalResponse
from rclpy.task import Future

from coursekit.nodes.cpp_node import CppNode, as_cpp
from coursekit.nodes.examples.action_server import MinimalActionServer, serve
from coursekit.nodes.running import run


class FibonacciServer(MinimalActionServer):
    """Serves the action `fibonacci`, one number a second; a goal may be cancelled."""

    NAME, KIND = "fibonacci_action_server", Fibonacci

    def _asked(self, goal: Fibonacci.Goal) -> GoalResponse:
        self.get_logger().info(f"Received goal request with order {goal.order}")
        return GoalResponse.ACCEPT

    def _cancel_asked(self, _: Any) -> CancelResponse:
        self.get_logger().info("Received request to cancel goal")
        return CancelResponse.ACCEPT

    def _execute(self, goal: Any) -> Fibonacci.Result:
        self.get_logger().info("Executing goal")
        numbers = [0, 1]
        for at in range(1, goal.request.order):
            if goal.is_cancel_requested:
                goal.canceled()
                self.get_logger().info("Goal canceled")
                return Fibonacci.Result(sequence=numbers)
            numbers.append(numbers[at] + numbers[at - 1])
            goal.publish_feedback(Fibonacci.Feedback(partial_sequence=numbers))
            self.get_logger().info("Publish feedback")
            time.sleep(1)
        goal.succeed()
        self.get_logger().info("Goal succeeded")
        return Fibonacci.Result(sequence=numbers)


class FibonacciClient(CppNode):
    """Requests ten steps and ends with the result."""

    def __init__(self) -> None:
        super().__init__("fibonacci_action_client")
        self._client = ActionClient(self, Fibonacci, "fibonacci")
        self._timer = self.create_timer(0.5, self._send)

    def _send(self) -> None:
        self._timer.cancel()
        if not self._client.wait_for_server(timeout_sec=10.0):
            self.get_logger().error("Action server not available after waiting")
            rclpy.shutdown()
            return
        self.get_logger().info("Sending goal")
        sent = self._client.send_goal_async(Fibonacci.Goal(order=10), feedback_callback=self._progressed)
        sent.add_done_callback(self._answered)

    def _answered(self, future: Future) -> None:
        if not future.result().accepted:
            self.get_logger().error("Goal was rejected by server")
            rclpy.shutdown()
            return
        self.get_logger().info("Goal accepted by server, waiting for result")
        future.result().get_result_async().add_done_callback(self._finished)

    def _progressed(self, msg: Any) -> None:
        numbers = "".join(f"{number} " for number in msg.feedback.partial_sequence)
        self.get_logger().info(f"Next number in sequence received: {numbers}")

    def _finished(self, future: Future) -> None:
        numbers = "".join(f"{number} " for number in future.result().result.sequence)
        self.get_logger().info(f"Result received: {numbers}")
        rclpy.shutdown()


def server(args: list[str] | None = None) -> int:
    """Serve until Ctrl-C."""
    return serve(as_cpp(FibonacciServer), args)


def client(args: list[str] | None = None) -> int:
    """Send one request."""
    return run(FibonacciClient, args)
