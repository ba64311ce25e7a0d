"""Names that a module of Humble's has beside its own because it uses them: programs import them from there too."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Any, TypeVar

_VARIABLES = {name: TypeVar(name) for name in ("MsgType", "SrvType", "SrvTypeRequest", "SrvTypeResponse")}  # type: ignore[misc]
_HOMES = {
    "action_msgs.msg": "GoalStatus",
    "rcl_interfaces.msg": (
        "FloatingPointRange IntegerRange ParameterDescriptor ParameterType ParameterValue SetParametersResult"
    ),
    "rclpy.callback_groups": "CallbackGroup MutuallyExclusiveCallbackGroup ReentrantCallbackGroup",
    "rclpy.clock": "Clock ClockType",
    "rclpy.context": "Context",
    "rclpy.event_handler": "PublisherEventCallbacks SubscriptionEventCallbacks",
    "rclpy.exceptions": (
        "InvalidParameterTypeException InvalidParameterValueException ParameterAlreadyDeclaredException "
        "ParameterImmutableException ParameterNotDeclaredException ParameterUninitializedException"
    ),
    "rclpy.executors": "Executor",
    "rclpy.guard_condition": "GuardCondition",
    "rclpy.node": "Node",
    "rclpy.parameter": "PARAMETER_SEPARATOR_STRING Parameter",
    "rclpy.qos": "QoSProfile qos_profile_services_default",
    "rclpy.qos_overriding_options": "QoSOverridingOptions",
    "rclpy.service": "Service",
    "rclpy.subscription": "Subscription",
    "rclpy.client": "Client",
    "rclpy.task": "Future Task",
    "rclpy.timer": "Rate Timer",
    "rclpy.topic_endpoint_info": "TopicEndpointInfo",
    "rclpy.waitable": "Waitable",
}
_HOME_OF = {name: home for home, names in _HOMES.items() for name in names.split()}


def lender(module: str) -> Callable[[str], Any]:
    """The `__getattr__` of a module that lends the names known here; they are imported when they are asked for.

    >>> lender("rclpy.node")("Rate").__module__
    'rclpy.timer'
    """

    def lend(name: str) -> Any:
        if name in _VARIABLES:
            return _VARIABLES[name]
        if name not in _HOME_OF:
            raise AttributeError(f"module '{module}' has no attribute '{name}'")
        return getattr(importlib.import_module(_HOME_OF[name]), name)

    return lend
