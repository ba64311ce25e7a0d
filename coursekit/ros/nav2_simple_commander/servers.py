"""The requests of a BasicNavigator: tasks, one at a time, and service calls."""

from __future__ import annotations

from typing import Any

import rclpy
from action_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped
from lifecycle_msgs.srv import GetState
from nav2_msgs.srv import ManageLifecycleNodes
from rclpy.action import ActionClient
from rclpy.node import Node

from nav2_simple_commander.task_result import TaskResult


class Servers(Node):
    """A node that sends goals to action servers and calls services, and waits for both."""

    def __init__(self, node_name: str, namespace: str) -> None:
        super().__init__(node_name, namespace=namespace)
        self.goal_handle: Any = None
        self.result_future: Any = None
        self.feedback: Any = None
        self.status: int | None = None
        self._navigator_actions: list[ActionClient] = []

    def _navigator_action(self, kind: Any, name: str) -> ActionClient:
        """A client of an action, destroyed with the node."""
        self._navigator_actions.append(ActionClient(self, kind, name))
        return self._navigator_actions[-1]

    def destroyNode(self) -> None:
        """Destroy the node."""
        self.destroy_node()

    def destroy_node(self) -> None:
        """Destroy the node and its clients."""
        for client in self._navigator_actions:
            client.destroy()
        self._navigator_actions.clear()
        super().destroy_node()

    # -- tasks

    def _navigator_give(self, client: ActionClient, name: str, goal: Any, what: str) -> bool:
        """Send a goal to an action server. Return whether it was accepted."""
        handle = self._navigator_send(client, name, goal, self._feedbackCallback)
        if not handle.accepted:
            self.error(f"{what} was rejected!")
            return False
        self.goal_handle, self.result_future = handle, handle.get_result_async()
        return True

    def _navigator_send(self, client: ActionClient, name: str, goal: Any, feedback: Any = None) -> Any:
        self.debug(f"Waiting for '{name}' action server")
        while not client.wait_for_server(timeout_sec=1.0):
            self.info(f"'{name}' action server not available, waiting...")
        sent = client.send_goal_async(goal, feedback)
        rclpy.spin_until_future_complete(self, sent)
        return sent.result()

    def _navigator_have_done(self, client: ActionClient, name: str, goal: Any, what: str) -> Any:
        """Send a goal and wait for its end. Return the action's result, or None if it was rejected or failed."""
        handle = self._navigator_send(client, name, goal)
        if not handle.accepted:
            self.error(f"{what} was rejected!")
            return None
        self.goal_handle, self.result_future = handle, handle.get_result_async()
        rclpy.spin_until_future_complete(self, self.result_future)
        answer = self.result_future.result()
        self.status = answer.status
        if self.status != GoalStatus.STATUS_SUCCEEDED:
            self.warn(f"Getting path failed with status code: {self.status}")
            return None
        return answer.result

    def cancelTask(self) -> None:
        """Cancel the current task of any kind."""
        self.info("Canceling current task.")
        if self.result_future:
            rclpy.spin_until_future_complete(self, self.goal_handle.cancel_goal_async())

    def isTaskComplete(self) -> bool:
        """Whether the task has ended, with any status; waits for up to a tenth of a second."""
        if not self.result_future:
            return True
        rclpy.spin_until_future_complete(self, self.result_future, timeout_sec=0.10)
        if not self.result_future.result():
            return False
        self.status = self.result_future.result().status
        if self.status != GoalStatus.STATUS_SUCCEEDED:
            self.debug(f"Task with failed with status code: {self.status}")
        else:
            self.debug("Task succeeded!")
        return True

    def getFeedback(self) -> Any:
        """The newest feedback of the task, or None."""
        return self.feedback

    def getResult(self) -> TaskResult:
        """The outcome of the task."""
        known = {
            GoalStatus.STATUS_SUCCEEDED: TaskResult.SUCCEEDED,
            GoalStatus.STATUS_ABORTED: TaskResult.FAILED,
            GoalStatus.STATUS_CANCELED: TaskResult.CANCELED,
        }
        return known.get(self.status or 0, TaskResult.UNKNOWN)

    def _feedbackCallback(self, msg: Any) -> None:
        self.feedback = msg.feedback

    # -- services

    def _navigator_call(self, client: Any, what: str, request: Any) -> Any:
        """Wait for a service and call it."""
        while not client.wait_for_service(timeout_sec=1.0):
            self.info(f"{what} service not available, waiting...")
        future = client.call_async(request)
        rclpy.spin_until_future_complete(self, future)
        return future.result()

    def _waitForNodeToActivate(self, node_name: str) -> None:
        """Wait until a managed node is active."""
        self.debug(f"Waiting for {node_name} to become active..")
        client = self.create_client(GetState, f"{node_name}/get_state")
        while not client.wait_for_service(timeout_sec=1.0):
            self.info(f"{node_name}/get_state service not available, waiting...")
        state = "unknown"
        while state != "active":
            future = client.call_async(GetState.Request())
            rclpy.spin_until_future_complete(self, future)
            if future.result() is not None:
                state = future.result().current_state.label
            if state != "active":
                self._navigator_wait(2.0)
        self.destroy_client(client)

    def _navigator_wait(self, seconds: float) -> None:
        """Spin for that long."""
        end = self.get_clock().now().nanoseconds + int(seconds * 1e9)
        while rclpy.ok() and (left := end - self.get_clock().now().nanoseconds) > 0:
            rclpy.spin_once(self, timeout_sec=min(left * 1e-9, 0.1))

    def _navigator_manage(self, command: int) -> None:
        """Send a command to every lifecycle manager."""
        for name, kinds in self.get_service_names_and_types():
            if "nav2_msgs/srv/ManageLifecycleNodes" in kinds:
                client = self.create_client(ManageLifecycleNodes, name)
                self._navigator_call(client, name, ManageLifecycleNodes.Request(command=command))
                self.destroy_client(client)

    # -- logging

    def info(self, msg: str) -> None:
        """Log an info message."""
        self.get_logger().info(msg)

    def warn(self, msg: str) -> None:
        """Log a warning."""
        self.get_logger().warning(msg)

    def error(self, msg: str) -> None:
        """Log an error."""
        self.get_logger().error(msg)

    def debug(self, msg: str) -> None:
        """Log a debug message."""
        self.get_logger().debug(msg)


def place_of(pose: PoseStamped) -> str:
    """Position of a pose as text."""
    return f"{pose.pose.position.x} {pose.pose.position.y}"
