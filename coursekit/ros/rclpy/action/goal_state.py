"""The states of a goal and the events that lead from one to the next. In ROS 2: rcl_action."""

from __future__ import annotations

from enum import IntEnum

from action_msgs.msg import GoalStatus

from rclpy._rclpy_pybind11 import RCLError


class GoalEvent(IntEnum):
    """The events of a goal."""

    EXECUTE = 0
    CANCEL_GOAL = 1
    SUCCEED = 2
    ABORT = 3
    CANCELED = 4


NAMES = {
    GoalStatus.STATUS_UNKNOWN: "UNKNOWN",
    GoalStatus.STATUS_ACCEPTED: "ACCEPTED",
    GoalStatus.STATUS_EXECUTING: "EXECUTING",
    GoalStatus.STATUS_CANCELING: "CANCELING",
    GoalStatus.STATUS_SUCCEEDED: "SUCCEEDED",
    GoalStatus.STATUS_CANCELED: "CANCELED",
    GoalStatus.STATUS_ABORTED: "ABORTED",
}
TERMINAL = (GoalStatus.STATUS_SUCCEEDED, GoalStatus.STATUS_CANCELED, GoalStatus.STATUS_ABORTED)

_NEXT = {
    (GoalStatus.STATUS_ACCEPTED, GoalEvent.EXECUTE): GoalStatus.STATUS_EXECUTING,
    (GoalStatus.STATUS_ACCEPTED, GoalEvent.CANCEL_GOAL): GoalStatus.STATUS_CANCELING,
    (GoalStatus.STATUS_EXECUTING, GoalEvent.CANCEL_GOAL): GoalStatus.STATUS_CANCELING,
    (GoalStatus.STATUS_EXECUTING, GoalEvent.SUCCEED): GoalStatus.STATUS_SUCCEEDED,
    (GoalStatus.STATUS_EXECUTING, GoalEvent.ABORT): GoalStatus.STATUS_ABORTED,
    (GoalStatus.STATUS_CANCELING, GoalEvent.SUCCEED): GoalStatus.STATUS_SUCCEEDED,
    (GoalStatus.STATUS_CANCELING, GoalEvent.ABORT): GoalStatus.STATUS_ABORTED,
    (GoalStatus.STATUS_CANCELING, GoalEvent.CANCELED): GoalStatus.STATUS_CANCELED,
}


def next_status(status: int, event: GoalEvent) -> int:
    """Return the status after the event; RCLError if the event is invalid in the current status.

    >>> next_status(GoalStatus.STATUS_EXECUTING, GoalEvent.SUCCEED) == GoalStatus.STATUS_SUCCEEDED
    True
    """
    try:
        return _NEXT[status, event]
    except KeyError:
        what = f"attempted invalid transition from state {NAMES[status]} with event {event.name}"
        raise RCLError(f"Failed to update goal state: goal_handle {what}") from None


def is_cancelable(status: int) -> bool:
    """Return whether a goal can still be cancelled."""
    return (status, GoalEvent.CANCEL_GOAL) in _NEXT
