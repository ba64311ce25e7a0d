"""The names of an action's services and topics."""

from __future__ import annotations

from typing import NamedTuple

from coursekit.rcl import names


class ActionNames(NamedTuple):
    """Three services, two topics."""

    send_goal: str
    cancel_goal: str
    get_result: str
    feedback: str
    status: str


def action_names(role: str, action_name: str) -> ActionNames:
    """Return the names for an action; ValueError for an invalid name. `role` is 'server' or 'client'.

    >>> action_names("client", "fibonacci").status
    'fibonacci/_action/status'
    """
    if reason := names.validate_topic_name(action_name):
        what = f"Failed to create action {role} due to invalid topic name '{action_name}'"
        raise ValueError(f"{what} : {reason[0]}")
    return ActionNames(*(f"{action_name}/_action/{part}" for part in ActionNames._fields))
