"""The return values of an action server's callbacks, and the default callbacks."""

from __future__ import annotations

from enum import Enum
from typing import Any

from rclpy.action.goal_handle import ServerGoalHandle


class GoalResponse(Enum):
    """The return value of a goal callback."""

    REJECT = 1
    ACCEPT = 2


class CancelResponse(Enum):
    """The return value of a cancel callback."""

    REJECT = 1
    ACCEPT = 2


def default_handle_accepted_callback(goal_handle: ServerGoalHandle) -> None:
    """Execute the goal at once."""
    goal_handle.execute()


def default_goal_callback(goal_request: Any) -> GoalResponse:
    """Accept every goal."""
    return GoalResponse.ACCEPT


def default_cancel_callback(cancel_request: Any) -> CancelResponse:
    """Reject every request to cancel."""
    return CancelResponse.REJECT
