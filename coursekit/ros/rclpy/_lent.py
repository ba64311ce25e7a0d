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
    "rclpy.clock": "Clock ClockType JumpHandle JumpThreshold ROSClock TimeJump",
    "rclpy.constants": "S_TO_NS",
    "rclpy.context": "Context",
    "rclpy.duration": "Duration",
    "rclpy.event_handler": "PublisherEventCallbacks SubscriptionEventCallbacks",
    "rclpy.exceptions": (
        "InvalidParameterTypeException InvalidParameterValueException ParameterAlreadyDeclaredException "
        "ParameterImmutableException ParameterNotDeclaredException ParameterUninitializedException"
    ),
    "rclpy.executors": "Executor MultiThreadedExecutor SingleThreadedExecutor",
    "rclpy.expand_topic_name": "expand_topic_name",
    "rclpy.guard_condition": "GuardCondition",
    "rclpy.logging": "get_logger",
    "rclpy.node": "Node",
    "rclpy.parameter": "PARAMETER_SEPARATOR_STRING Parameter",
    "rclpy.parameter_service": "ParameterService",
    "rclpy.publisher": "Publisher",
    "rclpy.qos": "QoSProfile qos_profile_action_status_default qos_profile_parameter_events qos_profile_services_default",
    "rclpy.qos_overriding_options": "QoSOverridingOptions",
    "rclpy.service": "Service",
    "rclpy.subscription": "Subscription",
    "rclpy.client": "Client",
    "rclpy.task": "Future Task",
    "rclpy.time": "Time",
    "rclpy.time_source": "TimeSource",
    "rclpy.timer": "Rate Timer",
    "rclpy.topic_endpoint_info": "TopicEndpointInfo",
    "rclpy.type_support": "check_for_type_support check_is_valid_msg_type check_is_valid_srv_type",
    "rclpy.utilities": "get_default_context ok timeout_sec_to_nsec",
    "rclpy.validate_full_topic_name": "validate_full_topic_name",
    "rclpy.validate_namespace": "validate_namespace",
    "rclpy.validate_node_name": "validate_node_name",
    "rclpy.validate_parameter_name": "validate_parameter_name",
    "rclpy.validate_topic_name": "validate_topic_name",
    "rclpy.waitable": "NumberOfEntities Waitable",
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
        if name == "_rclpy":
            return importlib.import_module("rclpy._rclpy_pybind11")
        if name not in _HOME_OF:
            raise AttributeError(f"module '{module}' has no attribute '{name}'")
        return getattr(importlib.import_module(_HOME_OF[name]), name)

    return lend
