"""A goal on the server's side."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from action_msgs.msg import GoalInfo, GoalStatus

from rclpy.action.goal_state import TERMINAL, GoalEvent, next_status

if TYPE_CHECKING:
    from rclpy.action.server import ActionServer


class ServerGoalHandle:
    """A goal that an action server has accepted; the server creates it."""

    def __init__(self, action_server: ActionServer, goal_info: GoalInfo, goal_request: Any) -> None:
        self._action_server: ActionServer | None = action_server
        self._goal_info = goal_info
        self._goal_request = goal_request
        self._status: int = GoalStatus.STATUS_ACCEPTED
        self._lock = threading.Lock()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ServerGoalHandle) and bytes(self.goal_id.uuid) == bytes(other.goal_id.uuid)

    def __hash__(self) -> int:
        return hash(bytes(self.goal_id.uuid))

    @property
    def request(self) -> Any:
        """The requested goal."""
        return self._goal_request

    @property
    def goal_id(self) -> Any:
        """The goal's UUID."""
        return self._goal_info.goal_id

    @property
    def is_active(self) -> bool:
        """Whether the goal is neither succeeded, canceled nor aborted."""
        return self._status not in TERMINAL

    @property
    def is_cancel_requested(self) -> bool:
        """Whether cancellation was requested; respond with `canceled()` and a result."""
        return self._status == GoalStatus.STATUS_CANCELING

    @property
    def status(self) -> int:
        """A number of action_msgs/msg/GoalStatus."""
        return self._status

    def execute(self, execute_callback: Callable[[ServerGoalHandle], Any] | None = None) -> None:
        """Execute the goal with the callback, or with the server's own; RCLError if the goal has ended."""
        if not self.is_cancel_requested:
            self._update_state(GoalEvent.EXECUTE)
        if self._action_server is not None:
            self._action_server.notify_execute(self, execute_callback)

    def publish_feedback(self, feedback: Any) -> None:
        """Publish feedback to the clients; TypeError for anything but the action's Feedback."""
        server = self._action_server
        if server is None:
            return
        if not isinstance(feedback, server.action_type.Feedback):
            raise TypeError(
                f"Expected {server.action_type.Feedback.__name__}, got {type(feedback).__name__}: "
                "publish_feedback takes the action's Feedback message"
            )
        server._publish_feedback(self.goal_id, feedback)

    def succeed(self) -> None:
        """Mark the goal as succeeded; RCLError if it is not being executed."""
        self._end(GoalEvent.SUCCEED)

    def abort(self) -> None:
        """Mark the goal as aborted; RCLError if it is not being executed."""
        self._end(GoalEvent.ABORT)

    def canceled(self) -> None:
        """Mark the goal as canceled; RCLError if no cancellation was requested."""
        self._end(GoalEvent.CANCELED)

    def _end(self, event: GoalEvent) -> None:
        self._update_state(event)
        if self._action_server is not None:
            self._action_server.notify_goal_done()

    def _update_state(self, event: GoalEvent) -> None:
        with self._lock:
            if self._action_server is None:
                return
            self._status = next_status(self._status, event)
        self._action_server._publish_status()

    def destroy(self) -> None:
        """Detach the handle from the server; later calls have no effect."""
        with self._lock:
            self._action_server = None
