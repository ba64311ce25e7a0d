"""Minimal action servers: goals in parallel, one at a time, in a queue, or deferred."""

import threading
import time
from collections import deque
from collections.abc import Callable
from typing import Any

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node

from coursekit.nodes.running import spin_to_the_end


class MinimalActionServer(Node):
    """Computes Fibonacci numbers on `fibonacci`, one a second, for any number of parallel goals."""

    NAME: str = "minimal_action_server"
    KIND: Any = Fibonacci

    def __init__(self, **callbacks: Any) -> None:
        super().__init__(self.NAME)
        self._server = ActionServer(
            self,
            self.KIND,
            "fibonacci",
            execute_callback=self._execute,
            goal_callback=self._asked,
            cancel_callback=self._cancel_asked,
            callback_group=ReentrantCallbackGroup(),
            **callbacks,
        )

    def destroy_node(self) -> None:
        """Destroy the action, then the node."""
        self._server.destroy()
        super().destroy_node()

    def _asked(self, _: Any) -> GoalResponse:
        self.get_logger().info("Received goal request")
        return GoalResponse.ACCEPT

    def _cancel_asked(self, _: Any) -> CancelResponse:
        self.get_logger().info("Received cancel request")
        return CancelResponse.ACCEPT

    def _execute(self, goal: Any) -> Any:
        self.get_logger().info("Executing goal...")
        numbers = [0, 1]
        for at in range(1, goal.request.order):
            if self._stopped(goal):
                return Fibonacci.Result()
            numbers.append(numbers[at] + numbers[at - 1])
            feedback = Fibonacci.Feedback(sequence=numbers)
            self.get_logger().info(f"Publishing feedback: {feedback.sequence}")
            goal.publish_feedback(feedback)
            time.sleep(1)
        goal.succeed()
        result = Fibonacci.Result(sequence=numbers)
        self.get_logger().info(f"Returning result: {result.sequence}")
        return result

    def _stopped(self, goal: Any) -> bool:
        if not goal.is_active:
            self.get_logger().info("Goal aborted")
            return True
        if goal.is_cancel_requested:
            goal.canceled()
            self.get_logger().info("Goal canceled")
            return True
        return False


class SingleGoalServer(MinimalActionServer):
    """A new goal aborts the previous one."""

    def __init__(self) -> None:
        self._current: Any = None
        self._lock = threading.Lock()
        super().__init__(handle_accepted_callback=self._accepted)

    def _accepted(self, goal: Any) -> None:
        with self._lock:
            if self._current is not None and self._current.is_active:
                self.get_logger().info("Aborting previous goal")
                self._current.abort()
            self._current = goal
        goal.execute()


class QueueServer(MinimalActionServer):
    """A new goal waits for earlier ones."""

    def __init__(self) -> None:
        self._queue: deque[Any] = deque()
        self._current: Any = None
        self._lock = threading.Lock()
        super().__init__(handle_accepted_callback=self._accepted)

    def _accepted(self, goal: Any) -> None:
        with self._lock:
            if self._current is not None:
                self._queue.append(goal)
                self.get_logger().info("Goal put in the queue")
                return
            self._current = goal
        goal.execute()

    def _execute(self, goal: Any) -> Any:
        try:
            return super()._execute(goal)
        finally:
            with self._lock:
                self._current = self._queue.popleft() if self._queue else None
            if self._current is not None:
                self.get_logger().info("Next goal pulled from the queue")
                self._current.execute()


class DeferringServer(MinimalActionServer):
    """A goal starts three seconds after its acceptance."""

    def __init__(self) -> None:
        super().__init__(handle_accepted_callback=self._accepted)

    def _accepted(self, goal: Any) -> None:
        self.get_logger().info("Deferring execution...")
        self._goal = goal
        self._timer = self.create_timer(3.0, self._begin)

    def _begin(self) -> None:
        self._timer.cancel()
        self._goal.execute()


def serve(make: Callable[[], Node], args: list[str] | None) -> int:
    """Run an action server until Ctrl-C, with goals in separate threads."""
    rclpy.init(args=args)
    return spin_to_the_end(make(), executor=MultiThreadedExecutor())


def server(args: list[str] | None = None) -> int:
    """Serve goals in parallel."""
    return serve(MinimalActionServer, args)


def server_single_goal(args: list[str] | None = None) -> int:
    """Serve one goal at a time."""
    return serve(SingleGoalServer, args)


def server_queue_goals(args: list[str] | None = None) -> int:
    """Serve goals one after the other."""
    return serve(QueueServer, args)


def server_defer(args: list[str] | None = None) -> int:
    """Serve deferred goals."""
    return serve(DeferringServer, args)
