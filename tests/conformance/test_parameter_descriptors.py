"""Descriptors of parameters: what they keep, and the ranges that values have to fit."""

import pytest
from rcl_interfaces.msg import (
    FloatingPointRange,
    IntegerRange,
    ParameterDescriptor,
    ParameterType,
    ParameterValue,
)
from rclpy.exceptions import (
    InvalidParameterValueException,
)
from rclpy.parameter import (
    Parameter,
)

Type = Parameter.Type


@pytest.fixture
def node(world):
    return world.node("n", namespace="/ns", spin=False)


def of_integers(**fields):
    return ParameterDescriptor(type=ParameterType.PARAMETER_INTEGER, **fields)


def up_to(last):
    return of_integers(integer_range=[IntegerRange(from_value=0, to_value=last)])


def test_a_new_descriptor_keeps_a_value_that_fits_and_else_takes_the_other(node):
    node.declare_parameter("speed", 7)
    other = ParameterValue(type=ParameterType.PARAMETER_INTEGER, integer_value=2)
    assert node.set_descriptor("speed", of_integers(description="in cm/s"), other).integer_value == 7
    assert node.describe_parameter("speed").description == "in cm/s"
    assert node.set_descriptor("speed", up_to(5), other).integer_value == 2
    with pytest.raises(InvalidParameterValueException):
        node.set_descriptor("speed", up_to(1))
    assert node.get_parameter("speed").value == 2


def test_a_new_descriptor_says_the_type(node):
    node.declare_parameter("speed", 7)
    with pytest.raises(InvalidParameterValueException, match="Wrong parameter type, expected"):
        node.set_descriptor("speed", ParameterDescriptor(description="in cm/s"))
    node.set_descriptor("speed", ParameterDescriptor(description="in cm/s", dynamic_typing=True))
    assert node.describe_parameter("speed").type == ParameterType.PARAMETER_INTEGER


@pytest.mark.parametrize(
    ("value", "fits"), [(0, True), (2, True), (10, True), (1, False), (11, False), (-1, False)]
)
def test_an_integer_range_with_steps(node, value, fits):
    limits = IntegerRange(from_value=0, to_value=10, step=2)
    node.declare_parameter("n", 4, ParameterDescriptor(integer_range=[limits]))
    assert node.set_parameters([Parameter("n", value=value)])[0].successful is fits


@pytest.mark.parametrize(
    ("value", "fits"), [(0.0, True), (0.5, True), (9.9, True), (0.25, False), (10.0, False), (9.5, True)]
)
def test_a_floating_point_range_with_steps(node, value, fits):
    limits = FloatingPointRange(from_value=0.0, to_value=9.9, step=0.5)
    node.declare_parameter("x", 1.0, ParameterDescriptor(floating_point_range=[limits]))
    assert node.set_parameters([Parameter("x", value=value)])[0].successful is fits


def test_a_value_outside_of_its_range_is_not_declared(node):
    limits = IntegerRange(from_value=0, to_value=10, step=1)
    with pytest.raises(InvalidParameterValueException):
        node.declare_parameter("n", 11, ParameterDescriptor(integer_range=[limits]))


def test_descriptors_are_kept(node):
    node.declare_parameter("speed", 1, ParameterDescriptor(description="metres per second"))
    described = node.describe_parameter("speed")
    assert (described.name, described.description) == ("speed", "metres per second")
    assert described.type == ParameterType.PARAMETER_INTEGER


def test_an_undeclared_parameter_has_an_empty_descriptor(world):
    node = world.node(allow_undeclared_parameters=True)
    assert node.describe_parameter("unheard") == ParameterDescriptor()


@pytest.mark.parametrize(("ends", "step", "value", "reason"), [
    ((0.0, 2.0), 0.0, 5.0, "Parameter x out of range Min: 0.0, Max: 2.0, value: 5.0"),
    ((2.0, 0.0), 0.0, 5.0, "Parameter x out of range Min: 0.0, Max: 2.0, value: 5.0"),
    ((2.0, 0.0), 0.5, 1.5, ""),
    ((0.0, 2.0), 0.5, 0.7,
     "The parameter value for x is not close enough to a valid step. Min: 0.0, max: 2.0, value: 0.7, step: 0.5"),
    ((0, 2), 0, 5, "Parameter x out of range. Min: 0, Max: 2, value: 5"),
    ((10, 1), 3, 12, "Parameter x out of range. Min: 1, Max: 10, value: 12"),
    ((10, 1), 3, 5, "The parameter value for x is not a valid step. Min: 1, max: 10, value: 5, step: 3"),
])  # fmt: skip
def test_why_a_value_does_not_fit_its_range(node, ends, step, value, reason):
    low, high = ends
    if isinstance(value, float):
        floats = FloatingPointRange(from_value=low, to_value=high, step=step)
        node.declare_parameter("x", 1.0, ParameterDescriptor(floating_point_range=[floats]))
    else:
        integers = IntegerRange(from_value=low, to_value=high, step=step)
        node.declare_parameter("x", 1, ParameterDescriptor(integer_range=[integers]))
    (result,) = node.set_parameters([Parameter("x", value=value)])
    assert (result.successful, result.reason) == (not reason, reason)
