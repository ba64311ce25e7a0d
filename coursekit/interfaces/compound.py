"""Service and action classes: groups of messages."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from coursekit.interfaces.metaclass import InterfaceType
from coursekit.interfaces.model import Action, Field, FieldType, Message

_GOAL_ID = Field(FieldType("unique_identifier_msgs/msg/UUID"), "goal_id")


def _refuse(what: str, short: str) -> Callable[[Any], None]:
    def __init__(self: Any) -> None:
        raise NotImplementedError(f"{what} classes can not be instantiated")

    __init__.__qualname__ = f"{short}.__init__"  # Python's own errors quote it
    return __init__


def _make_class(what: str, full_name: str, module: str, members: dict[str, Any]) -> Any:
    short = full_name.rsplit("/", 1)[1]
    meta = type(f"Metaclass_{short}", (InterfaceType,), {"__module__": module})
    body = {"__module__": module, "__doc__": f"{what} class '{short}'.", "_TYPE_NAME": full_name}
    return meta(short, (), {**body, "__init__": _refuse(what, short), **members})


def make_service(full_name: str, classes: dict[str, Any], module: str) -> Any:
    """Add the service class to `classes`, which hold its request and response."""
    members = {"Request": classes[f"{full_name}_Request"], "Response": classes[f"{full_name}_Response"]}
    classes[full_name] = _make_class("Service", full_name, module, members)
    return classes[full_name]


def action_parts(action: Action) -> list[Message]:
    """Return the messages of an action's two services and its feedback topic."""
    base = action.full_name
    layouts = {
        "_SendGoal_Request": [_GOAL_ID, Field(FieldType(f"{base}_Goal"), "goal")],
        "_SendGoal_Response": [
            Field(FieldType("bool"), "accepted"),
            Field(FieldType("builtin_interfaces/msg/Time"), "stamp"),
        ],
        "_GetResult_Request": [_GOAL_ID],
        "_GetResult_Response": [
            Field(FieldType("int8"), "status"),
            Field(FieldType(f"{base}_Result"), "result"),
        ],
        "_FeedbackMessage": [_GOAL_ID, Field(FieldType(f"{base}_Feedback"), "feedback")],
    }
    return [
        Message(action.package, "action", action.name + suffix, tuple(f)) for suffix, f in layouts.items()
    ]


def make_action(full_name: str, classes: dict[str, Any], module: str, load: Callable[[str], Any]) -> Any:
    """Add the action class and its services to `classes`."""
    send_goal = make_service(f"{full_name}_SendGoal", classes, module)
    get_result = make_service(f"{full_name}_GetResult", classes, module)
    implementation = type(
        "Impl",
        (),
        {
            "__module__": module,
            "SendGoalService": send_goal,
            "GetResultService": get_result,
            "FeedbackMessage": classes[f"{full_name}_FeedbackMessage"],
            "CancelGoalService": load("action_msgs/srv/CancelGoal"),
            "GoalStatusMessage": load("action_msgs/msg/GoalStatusArray"),
        },
    )
    members = {part: classes[f"{full_name}_{part}"] for part in ("Goal", "Result", "Feedback")}
    classes[full_name] = _make_class("Action", full_name, module, {**members, "Impl": implementation})
    return classes[full_name]
