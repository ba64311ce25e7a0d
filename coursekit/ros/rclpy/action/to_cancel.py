"""The goals that a request to cancel selects. In ROS 2: rcl_action_process_cancel_request."""

from __future__ import annotations

from typing import Any

from action_msgs.msg import GoalInfo
from action_msgs.srv import CancelGoal

from rclpy.action.goal_state import is_cancelable


def goals_to_cancel(asked: GoalInfo, handles: list[Any]) -> tuple[int, list[Any]]:
    """Return the return code and the selected goals.

    An id selects that goal; a stamp selects the goals accepted until then; neither selects every goal.
    """
    wanted = bytes(asked.goal_id.uuid)
    stamp = _nanoseconds(asked.stamp)
    has_id = any(wanted)
    if has_id and not stamp:
        return _one(wanted, handles)
    active = [each for each in handles if is_cancelable(each.status)]
    if not has_id and not stamp:
        return CancelGoal.Response.ERROR_NONE, active
    meant = [
        each
        for each in active
        if bytes(each.goal_id.uuid) == wanted or _nanoseconds(each._goal_info.stamp) <= stamp
    ]
    return CancelGoal.Response.ERROR_NONE, meant


def _one(wanted: bytes, handles: list[Any]) -> tuple[int, list[Any]]:
    for each in handles:
        if bytes(each.goal_id.uuid) == wanted:
            if is_cancelable(each.status):
                return CancelGoal.Response.ERROR_NONE, [each]
            return CancelGoal.Response.ERROR_GOAL_TERMINATED, []
    return CancelGoal.Response.ERROR_UNKNOWN_GOAL_ID, []


def _nanoseconds(stamp: Any) -> int:
    return stamp.sec * 10**9 + stamp.nanosec
