"""The answers of an action server's callbacks, and the callbacks when a program gives none."""

from __future__ import annotations

from enum import Enum
from typing import Any

from rclpy.action.goal_handle import ServerGoalHandle


class GoalResponse(Enum):
    """A goal callback's answer."""

    REJECT = 1
    ACCEPT = 2


class CancelResponse(Enum):
    """A cancel callback's answer."""

    REJECT = 1
    ACCEPT = 2


def default_handle_accepted_callback(goal_handle: ServerGoalHandle) -> None:
    """Execute the goal at once."""
    goal_handle.execute()


def default_goal_callback(goal_request: Any) -> GoalResponse:
    """Accept every goal."""
    return GoalResponse.ACCEPT


def default_cancel_callback(cancel_request: Any) -> CancelResponse:
    """Refuse to cancel."""
    return CancelResponse.REJECT
