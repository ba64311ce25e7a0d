"""A goal on the client's side."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from action_msgs.msg import GoalStatus

from rclpy.action.goal_state import TERMINAL
from rclpy.task import Future

if TYPE_CHECKING:
    from rclpy.action.client import ActionClient


class ClientGoalHandle:
    """The result of `send_goal_async`: whether the goal was accepted, and access to its result."""

    def __init__(self, action_client: ActionClient, goal_id: Any, goal_response: Any) -> None:
        self._action_client = action_client
        self._goal_id = goal_id
        self._goal_response = goal_response
        accepted = goal_response.accepted
        self._status: int = GoalStatus.STATUS_ACCEPTED if accepted else GoalStatus.STATUS_UNKNOWN

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ClientGoalHandle) and bytes(self._goal_id.uuid) == bytes(other._goal_id.uuid)

    def __hash__(self) -> int:
        return hash(bytes(self._goal_id.uuid))

    def __repr__(self) -> str:
        return f"ClientGoalHandle <id={self._goal_id.uuid}, accepted={self.accepted}, status={self.status}>"

    @property
    def goal_id(self) -> Any:
        """The goal's UUID."""
        return self._goal_id

    @property
    def stamp(self) -> Any:
        """When the server accepted the goal."""
        return self._goal_response.stamp

    @property
    def accepted(self) -> bool:
        """Whether the server accepted the goal."""
        return self._goal_response.accepted

    @property
    def status(self) -> int:
        """The last known status, a number of action_msgs/msg/GoalStatus."""
        return self._status

    def _update_status(self, status: int) -> None:
        if self._status not in TERMINAL:
            self._status = status

    def cancel_goal(self) -> Any:
        """Request cancellation and wait for the response; never in a callback of the executor that must take it."""
        return self._action_client._cancel_goal(self)

    def cancel_goal_async(self) -> Future:
        """Request cancellation; the future gets an action_msgs/srv/CancelGoal response."""
        return self._action_client._cancel_goal_async(self)

    def get_result(self) -> Any:
        """Wait for the result; never in a callback of the executor that must take it."""
        return self._action_client._get_result(self)

    def get_result_async(self) -> Future:
        """Request the result; the future gets a response with `status` and `result`."""
        return self._action_client._get_result_async(self)
