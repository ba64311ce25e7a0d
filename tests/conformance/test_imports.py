"""Programs take names from the modules where Humble's rclpy happens to have them, not only from their homes."""

import importlib

import pytest

LENT = [
    ("rclpy", "Parameter", "rclpy.parameter"),
    ("rclpy", "Future", "rclpy.task"),
    ("rclpy", "Context", "rclpy.context"),
    ("rclpy.action.client", "GoalStatus", "action_msgs.msg"),
    ("rclpy.executors", "Task", "rclpy.task"),
    ("rclpy.node", "CallbackGroup", "rclpy.callback_groups"),
    ("rclpy.node", "Context", "rclpy.context"),
    ("rclpy.node", "Executor", "rclpy.executors"),
    ("rclpy.node", "FloatingPointRange", "rcl_interfaces.msg"),
    ("rclpy.node", "IntegerRange", "rcl_interfaces.msg"),
    ("rclpy.node", "ParameterDescriptor", "rcl_interfaces.msg"),
    ("rclpy.node", "ParameterNotDeclaredException", "rclpy.exceptions"),
    ("rclpy.node", "ParameterType", "rcl_interfaces.msg"),
    ("rclpy.node", "ParameterValue", "rcl_interfaces.msg"),
    ("rclpy.node", "QoSOverridingOptions", "rclpy.qos_overriding_options"),
    ("rclpy.node", "Rate", "rclpy.timer"),
    ("rclpy.node", "ReentrantCallbackGroup", "rclpy.callback_groups"),
    ("rclpy.node", "SetParametersResult", "rcl_interfaces.msg"),
    ("rclpy.node", "TopicEndpointInfo", "rclpy.topic_endpoint_info"),
    ("rclpy.node", "Waitable", "rclpy.waitable"),
    ("rclpy.wait_for_message", "Node", "rclpy.node"),
]


@pytest.mark.parametrize(("module", "name", "home"), LENT)
def test_a_module_lends_what_it_uses(module, name, home):
    assert getattr(importlib.import_module(module), name) is getattr(importlib.import_module(home), name)


@pytest.mark.parametrize(
    ("module", "name"),
    [
        ("rclpy.client", "SrvType"),
        ("rclpy.client", "SrvTypeRequest"),
        ("rclpy.client", "SrvTypeResponse"),
        ("rclpy.node", "MsgType"),
        ("rclpy.node", "SrvType"),
        ("rclpy.node", "SrvTypeRequest"),
        ("rclpy.publisher", "MsgType"),
        ("rclpy.service", "SrvType"),
        ("rclpy.subscription", "MsgType"),
    ],
)
def test_signatures_can_name_a_type_of_messages_or_services(module, name):
    assert hasattr(importlib.import_module(module), name)


def test_severities_have_a_module_of_their_own():
    from rclpy.impl.logging_severity import LoggingSeverity

    assert int(LoggingSeverity.INFO) == 20


@pytest.mark.parametrize("module", ["rclpy", "rclpy.node", "rclpy.executors"])
def test_a_module_says_which_name_it_does_not_have(module):
    with pytest.raises(AttributeError, match=f"module '{module}' has no attribute 'no_such_name'"):
        importlib.import_module(module).no_such_name  # noqa: B018
