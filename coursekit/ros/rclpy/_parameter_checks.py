"""The form of parameter declarations, and the values that parameter ranges allow."""

from __future__ import annotations

import math
import warnings
from typing import Any

from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor, ParameterValue

from rclpy.parameter import Parameter


def read_declaration(index: int, declaration: Any) -> tuple[str, Any, ParameterDescriptor]:
    """(name, value, descriptor) of one tuple that was passed to declare_parameters.

    A ParameterValue is left unchanged: it only gives a type and requires an override, which the caller checks.
    """
    if len(declaration) < 1 or len(declaration) > 3:
        raise TypeError(
            f"Invalid parameter tuple length at index {index} in parameters list: "
            f"{declaration}; expecting length between 1 and 3"
        )
    name = declaration[0]
    if not isinstance(name, str):
        raise TypeError(f"First element {name} at index {index} in parameters list is not a str.")
    if len(declaration) == 1:
        _warn_name_only(name)
        return name, None, ParameterDescriptor(name=name, dynamic_typing=True)
    descriptor = declaration[2] if len(declaration) == 3 else ParameterDescriptor()
    if not isinstance(descriptor, ParameterDescriptor):
        raise TypeError(
            f"Third element {descriptor} at index {index} in parameters list is not a ParameterDescriptor."
        )
    descriptor = descriptor._clone()  # type: ignore[attr-defined]
    value = declaration[1]
    if isinstance(value, Parameter.Type):
        if value == Parameter.Type.NOT_SET:
            raise ValueError(f"Cannot declare parameter {{{name}}} as statically typed of type NOT_SET")
        if descriptor.dynamic_typing:
            raise ValueError(
                f"When declaring parameter {{{name}}} passing a descriptor with "
                "`dynamic_typing=True` is not allowed when the parameter type is provided"
            )
        descriptor.type = value.value
        return name, None, descriptor
    if isinstance(value, ParameterValue):
        if not descriptor.dynamic_typing:
            if value.type == Parameter.Type.NOT_SET.value:
                raise ValueError(
                    "Cannot declare a statically typed parameter with default value of type PARAMETER_NOT_SET"
                )
            descriptor.type = value.type
        return name, value, descriptor
    if not descriptor.dynamic_typing and value is not None:
        descriptor.type = Parameter.Type.from_parameter_value(value).value
    return name, value, descriptor


def _warn_name_only(name: str) -> None:
    warnings.warn(
        f"when declaring parameter named '{name}', declaring a parameter only providing its name is deprecated. "
        "You have to either:\n"
        '\t- Pass a name and a default value different to "PARAMETER NOT SET" (and optionally a descriptor).\n'
        "\t- Pass a name and a parameter type.\n"
        "\t- Pass a name and a descriptor with `dynamic_typing=True",
        stacklevel=5,
    )


def _no_step(parameter: Parameter, fault: str, low: float, high: float, step: float) -> str:
    return (
        f"The parameter value for {parameter.name} is not {fault} valid step. Min: {low}, "
        f"max: {high}, value: {parameter.value}, step: {step}"
    )


def outside_integer_range(parameter: Parameter, allowed: IntegerRange) -> str:
    """Why a value is outside a range, whose ends may come in either order; empty when it is inside."""
    value, (low, high) = parameter.value, sorted((allowed.from_value, allowed.to_value))
    if value in (low, high):
        return ""
    if not low <= value <= high:
        return f"Parameter {parameter.name} out of range. Min: {low}, Max: {high}, value: {value}"
    if allowed.step and (value - low) % allowed.step:
        return _no_step(parameter, "a", low, high, allowed.step)
    return ""


def outside_floating_range(parameter: Parameter, allowed: FloatingPointRange, tolerance: float) -> str:
    """Why a value is outside a range, whose ends may come in either order; empty when it is inside.

    A value at a limit, within the relative tolerance, is inside.
    """
    value, (low, high) = parameter.value, sorted((allowed.from_value, allowed.to_value))
    if any(math.isclose(value, end, rel_tol=tolerance) for end in (low, high)):
        return ""
    if not low <= value <= high:  # without a full stop, in rclpy
        return f"Parameter {parameter.name} out of range Min: {low}, Max: {high}, value: {value}"
    if allowed.step:
        steps = (value - low) / allowed.step
        if not math.isclose(steps, round(steps), rel_tol=tolerance):
            return _no_step(parameter, "close enough to a", low, high, allowed.step)
    return ""
