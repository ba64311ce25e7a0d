"""Names that a module of Humble's rclpy imports for its own use: programs import them from there too.

Each module has its own table, which follows its imports in Humble: a name that cannot be imported on a robot cannot
be imported here either.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Any, TypeVar

_VARIABLES = {name: TypeVar(name) for name in ("MsgType", "SrvType", "SrvTypeRequest", "SrvTypeResponse")}  # type: ignore[misc]
_SERVICE_TYPES = "SrvType SrvTypeRequest SrvTypeResponse"
_HOMES = {
    "rcl_interfaces.msg": (
        "FloatingPointRange IntegerRange ParameterDescriptor ParameterEvent ParameterType ParameterValue SetParametersResult"
    ),
    "rcl_interfaces.srv": "ListParameters",
    "action_msgs.msg": "GoalStatus GoalStatusArray",
    "action_msgs.srv": "CancelGoal",
    "rclpy.callback_groups": "CallbackGroup MutuallyExclusiveCallbackGroup ReentrantCallbackGroup",
    "rclpy.client": "Client",
    "rclpy.clock": "Clock ClockType ROSClock",
    "rclpy.constants": "S_TO_NS",
    "rclpy.context": "Context",
    "rclpy.duration": "Duration",
    "rclpy.exceptions": (
        "InvalidHandle InvalidParameterTypeException InvalidParameterValueException InvalidTopicNameException "
        "NotInitializedException ParameterAlreadyDeclaredException ParameterImmutableException "
        "ParameterNotDeclaredException ParameterUninitializedException"
    ),
    "rclpy.executors": "Executor",
    "rclpy.expand_topic_name": "expand_topic_name",
    "rclpy.guard_condition": "GuardCondition",
    "rclpy.logging": "get_logger",
    "rclpy.node": "Node",
    "rclpy.parameter": "PARAMETER_SEPARATOR_STRING Parameter",
    "rclpy.parameter_service": "ParameterService",
    "rclpy.publisher": "Publisher",
    "rclpy.qos": "QoSProfile qos_profile_action_status_default qos_profile_parameter_events qos_profile_services_default",
    "rclpy.qos_event": "PublisherEventCallbacks QoSEventHandler SubscriptionEventCallbacks",
    "rclpy.qos_overriding_options": "QoSOverridingOptions",
    "rclpy.service": "Service",
    "rclpy.signals": "SignalHandlerGuardCondition",
    "rclpy.subscription": "Subscription",
    "rclpy.task": "Future Task",
    "rclpy.time_source": "TimeSource",
    "rclpy.timer": "Rate Timer",
    "rclpy.topic_endpoint_info": "TopicEndpointInfo",
    "rclpy.type_support": "check_for_type_support check_is_valid_msg_type check_is_valid_srv_type",
    "rclpy.utilities": "get_default_context timeout_sec_to_nsec",
    "rclpy.validate_full_topic_name": "validate_full_topic_name",
    "rclpy.validate_namespace": "validate_namespace",
    "rclpy.validate_node_name": "validate_node_name",
    "rclpy.validate_parameter_name": "validate_parameter_name",
    "rclpy.validate_topic_name": "validate_topic_name",
    "rclpy.waitable": "NumberOfEntities Waitable",
}
_HOME_OF = {name: home for home, names in _HOMES.items() for name in names.split()}
_LENT = {
    "rclpy": "Context Future Parameter",
    "rclpy.action.client": "GoalStatus",
    "rclpy.client": f"CallbackGroup Context QoSProfile {_SERVICE_TYPES}",
    "rclpy.executors": (
        "Client Clock ClockType Context GuardCondition InvalidHandle NumberOfEntities Service SignalHandlerGuardCondition "
        "Subscription Task Timer Waitable get_default_context timeout_sec_to_nsec"
    ),
    "rclpy.node": (
        "CallbackGroup Context Executor FloatingPointRange IntegerRange InvalidParameterTypeException "
        "InvalidParameterValueException ListParameters MsgType PARAMETER_SEPARATOR_STRING ParameterAlreadyDeclaredException "
        "ParameterImmutableException ParameterNotDeclaredException ParameterType ParameterUninitializedException "
        "ParameterValue PublisherEventCallbacks QoSOverridingOptions Rate ReentrantCallbackGroup S_TO_NS "
        "SetParametersResult SubscriptionEventCallbacks TopicEndpointInfo Waitable check_is_valid_msg_type "
        "check_is_valid_srv_type expand_topic_name qos_profile_services_default validate_full_topic_name "
        f"validate_parameter_name validate_topic_name {_SERVICE_TYPES}"
    ),
    "rclpy.publisher": "CallbackGroup MsgType PublisherEventCallbacks QoSEventHandler QoSProfile",
    "rclpy.service": f"CallbackGroup QoSProfile {_SERVICE_TYPES}",
    "rclpy.subscription": "CallbackGroup MsgType QoSEventHandler QoSProfile SubscriptionEventCallbacks",
    "rclpy.wait_for_message": "Node QoSProfile SignalHandlerGuardCondition timeout_sec_to_nsec",
}


def lender(module: str) -> Callable[[str], Any]:
    """The `__getattr__` of a module that re-exports the names in its table; each is imported on access.

    >>> lender("rclpy.node")("Rate").__module__
    'rclpy.timer'
    >>> lender("rclpy.publisher")("Rate")
    Traceback (most recent call last):
        ...
    AttributeError: module 'rclpy.publisher' has no attribute 'Rate'
    """
    lent = set(_LENT[module].split())

    def lend(name: str) -> Any:
        if name == "_rclpy" and module != "rclpy":
            return importlib.import_module("rclpy._rclpy_pybind11")
        if name not in lent:
            raise AttributeError(f"module '{module}' has no attribute '{name}'")
        return _VARIABLES[name] if name in _VARIABLES else getattr(importlib.import_module(_HOME_OF[name]), name)

    return lend
