"""Nodes that stand for C++ programs have what rclcpp gives to each node, and refuse in its words."""

import pytest
import rclpy
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor
from rcl_interfaces.srv import SetParameters, SetParametersAtomically
from rclpy.parameter import Parameter

from coursekit.nodes.cpp_node import CppNode
from coursekit.processes.session import Session

DEPTH = "qos_overrides./parameter_events.publisher.depth"


@pytest.fixture
def node():
    with Session(virtual=True).use():
        rclpy.init(args=[])
        cpp_node = CppNode("node")
        cpp_node.declare_parameter("red", 1, ParameterDescriptor(integer_range=[IntegerRange(to_value=255, step=1)]))
        cpp_node.declare_parameter(
            "speed", 1.0, ParameterDescriptor(floating_point_range=[FloatingPointRange(to_value=2.0)])
        )
        yield cpp_node
        cpp_node.destroy_node()
        rclpy.try_shutdown()


def test_it_has_the_qos_of_its_events_as_parameters_and_hears_those_of_others(node):
    assert node.get_parameter(DEPTH).value == 1000
    assert {name: node.get_parameter(name).value for name in node._parameters if name.startswith("qos_")} == {
        DEPTH: 1000,
        "qos_overrides./parameter_events.publisher.durability": "volatile",
        "qos_overrides./parameter_events.publisher.history": "keep_last",
        "qos_overrides./parameter_events.publisher.reliability": "reliable",
    }
    heard = node.get_subscriber_names_and_types_by_node("node", "/")
    assert ("/parameter_events", ["rcl_interfaces/msg/ParameterEvent"]) in heard


@pytest.mark.parametrize(
    ("name", "value", "reason"),
    [
        (DEPTH, 3, f"parameter '{DEPTH}' cannot be set because it is read-only"),
        (
            "red",
            "dark",
            "Wrong parameter type, parameter {red} is of type {integer}, setting it to {string} is not allowed.",
        ),
        ("red", 300, "Parameter {red} doesn't comply with integer range."),
        ("speed", 2.5, "Parameter {speed} doesn't comply with floating point range."),
        ("speed", None, "cannot undeclare an statically typed parameter"),
    ],
)
def test_it_refuses_parameters_in_the_words_of_rclcpp(node, name, value, reason):
    result = node.set_parameters([Parameter(name, value=value)])[0]
    assert (result.successful, result.reason) == (False, reason)


UNDECLARED = {
    SetParameters: "parameter 'sped' cannot be set because it was not declared",
    SetParametersAtomically: "One or more parameters were not declared before setting",
}


@pytest.mark.parametrize("kind", UNDECLARED, ids=lambda kind: kind.__name__)
def test_its_services_say_in_those_words_that_a_parameter_is_not_declared(node, kind):
    name = {SetParameters: "set_parameters", SetParametersAtomically: "set_parameters_atomically"}[kind]
    client = node.create_client(kind, f"/node/{name}")
    asked = client.call_async(kind.Request(parameters=[Parameter("sped", value=1).to_parameter_msg()]))
    rclpy.spin_until_future_complete(node, asked, timeout_sec=5.0)
    answer = asked.result()
    result = answer.results[0] if kind is SetParameters else answer.result
    assert (result.successful, result.reason) == (False, UNDECLARED[kind])


@pytest.mark.parametrize(
    ("value", "reason"),
    [
        (300, "Parameter {fixed} doesn't comply with integer range."),
        ("dark", "Wrong parameter type, parameter {fixed} is of type {integer}, setting it to {string} is not allowed."),
    ],
)
def test_what_is_read_only_is_declared_with_a_value_or_refused_for_that_value(node, value, reason):
    fixed = ParameterDescriptor(type=2, read_only=True, integer_range=[IntegerRange(to_value=255, step=1)])
    result = node._rclpy_check(Parameter("fixed", value=value), fixed, check_read_only=False)
    assert (result.successful, result.reason) == (False, reason)


@pytest.mark.parametrize(("value", "fits"), [(10, True), (0, True), (5, False), (11, False)])
def test_in_a_range_from_high_to_low_only_its_ends_fit(node, value, fits):
    turned = ParameterDescriptor(type=2, integer_range=[IntegerRange(from_value=10, to_value=0)])
    result = node._rclpy_check(Parameter("turned", value=value), turned, check_read_only=False)
    assert result.successful is fits
    assert result.reason == ("" if fits else "Parameter {turned} doesn't comply with integer range.")


def test_what_fits_is_set(node):
    assert node.set_parameters([Parameter("red", value=7)])[0].successful
    assert node.get_parameter("red").value == 7
