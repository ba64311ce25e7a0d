"""A compiled program's requests about its nodes' parameters."""

from __future__ import annotations

import os
import re
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import ListParametersResult, ParameterDescriptor, ParameterValue, SetParametersResult
from rcl_interfaces.msg import Parameter as ParameterMessage
from rclpy.exceptions import (
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
from rclpy.parameter import PARAMETER_SEPARATOR_STRING, Parameter
from rclpy.parameter_service import is_listed

from coursekit.nodes.compiled.frames import Unpacker, packed
from coursekit.nodes.cpp_node import undeclared, wrong_type
from coursekit.rcl import parameter_file

if TYPE_CHECKING:
    from rclpy.node import Node

    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host


_ARRAYS = {
    5: "byte_array_value", 6: "bool_array_value", 7: "integer_array_value", 8: "double_array_value", 9: "string_array_value",
}  # fmt: skip
"""The fields of a ParameterValue that hold arrays, by their types."""


def do_declare(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Declare a parameter, with a value or only with a type. Returns its value."""
    node, name, kind = host.things[frame.integer()], frame.text(), frame.integer()
    value, descriptor = frame.message(ParameterValue), frame.message(ParameterDescriptor)
    ignore = bool(frame.integer())
    default: Any = Parameter.Type(kind)
    if not kind and value.type in _ARRAYS and not len(getattr(value, _ARRAYS[value.type])):
        return _declare_empty(node, Parameter(name, Parameter.Type(value.type), []), descriptor, ignore)
    if not kind:
        default = Parameter.from_parameter_msg(ParameterMessage(name=name, value=value)).value
        descriptor.dynamic_typing = descriptor.dynamic_typing or value.type == 0
    return packed(node.declare_parameter(name, default, descriptor, ignore).get_parameter_value())


def told(error: ParameterException) -> str:
    """Return rclcpp's message in place of rclpy's tuple.

    >>> told(ParameterUninitializedException("speed"))
    "parameter 'speed' is not initialized"
    """
    text, names = error.args[:2]
    name = names if isinstance(names, str) else ", ".join(names)
    if isinstance(error, ParameterUninitializedException):
        return f"parameter '{name}' is not initialized"
    if isinstance(error, ParameterAlreadyDeclaredException):
        return f"parameter '{name}' has already been declared"
    if isinstance(error, InvalidParameterValueException):
        return f"parameter '{name}' could not be set: {text.partition('Reason: ')[2]}"
    if isinstance(error, InvalidParameterTypeException):
        given, declared = (Parameter.Type[kind] for kind in re.findall(r"(?<= type ')\w+(?=')", text)[-2:])
        return f"parameter '{name}' has invalid type: {wrong_type(name, declared, given)}"
    return name if isinstance(error, ParameterNotDeclaredException) else str(text)


def _declare_empty(node: Node, given: Parameter, descriptor: ParameterDescriptor, ignore: bool) -> bytes:
    """Declare an empty array, whose element type is unknown from its Python value."""
    kind = None if descriptor.dynamic_typing else given.type_
    declared = node.declare_parameter(given.name, kind, descriptor, ignore)
    if declared.type_ == Parameter.Type.NOT_SET:
        result = node._rclpy_apply([given], declares=True)
        if not result.successful:
            node._parameters.pop(given.name)
            raise InvalidParameterValueException(given.name, given.value, result.reason)
        declared = node.get_parameter(given.name)
    return packed(declared.get_parameter_value())


def do_parameter_file(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the parameters in a file by node patterns, or of one node if it is named."""
    path, node = frame.text(), frame.text()
    try:
        values_by_node = parameter_file.read(os.path.join(host.process.cwd, path))
    except (OSError, ValueError) as error:
        raise RuntimeError(f"Error opening parameter file '{path}': {error}") from None
    if node:
        values_by_node = {node: parameter_file.values_for(values_by_node, node)}
    parts = [packed(len(values_by_node))]
    for name, values in values_by_node.items():
        parts.append(
            packed(name, len(values), *(Parameter(name, value=value).to_parameter_msg() for name, value in values.items()))
        )
    return b"".join(parts)


def do_parameter_value(_host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the parameter value of a YAML text."""
    try:
        value = parameter_file.parse_value(frame.text())
    except ValueError as error:
        raise RuntimeError(str(error)) from None
    return packed(Parameter("value", value=value).get_parameter_value())


def do_undeclare(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Undeclare a parameter."""
    host.things[frame.integer()].undeclare_parameter(frame.text())


def do_has_parameter(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Whether a parameter is declared."""
    return packed(int(host.things[frame.integer()].has_parameter(frame.text())))


def do_get_parameter(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """A parameter."""
    return packed(host.things[frame.integer()].get_parameter(frame.text()).to_parameter_msg())


def do_find_parameter(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return whether a parameter is declared and has a value, and the parameter."""
    node, name = host.things[frame.integer()], frame.text()
    try:
        parameter = node.get_parameter(name) if node.has_parameter(name) else None
    except ParameterUninitializedException:
        parameter = None
    if parameter is None or parameter.type_ is Parameter.Type.NOT_SET:
        return packed(0)
    return packed(1, parameter.to_parameter_msg())


def do_set_parameters(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Set parameters individually or atomically."""
    node, together = host.things[frame.integer()], frame.integer()
    wanted = [Parameter.from_parameter_msg(frame.message(ParameterMessage)) for _ in range(frame.integer())]
    try:
        results = [node.set_parameters_atomically(wanted)] if together else node.set_parameters(wanted)
    except ParameterNotDeclaredException as error:
        raise ParameterNotDeclaredException(undeclared(error)) from None
    return packed(len(results), *results)


def do_describe_parameter(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """A parameter's descriptor."""
    return packed(host.things[frame.integer()].describe_parameter(frame.text()))


def do_list_parameters(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the names of parameters below some prefixes."""
    node, depth = host.things[frame.integer()], frame.integer()
    prefixes = [frame.text() for _ in range(frame.integer())]
    names = [name for name in node._rclpy_listed_names() if is_listed(name, prefixes, depth)]
    above = [name.rpartition(PARAMETER_SEPARATOR_STRING)[0] for name in names]
    return packed(ListParametersResult(names=names, prefixes=list(dict.fromkeys(filter(None, above)))))


def do_on_set_parameters(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Add a callback that validates new parameter values."""
    node, handler = host.things[frame.integer()], frame.integer()

    def judge(wanted: list[Parameter]) -> Any:
        data = packed(len(wanted), *(parameter.to_parameter_msg() for parameter in wanted))
        return host.call(handler, data).message(SetParametersResult)

    node.add_on_set_parameters_callback(judge)
    return packed(host.keep((node, "remove_on_set_parameters_callback", judge)))


def do_remove_on_set_parameters(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Remove that callback; 0 if it was not registered."""
    entry = host.things.pop(frame.integer(), None)
    if entry is None:
        return packed(0)
    node, how, judge = entry
    getattr(node, how)(judge)
    return packed(1)
