"""Parameters: a name, a type, a value. In ROS 2: rclpy.parameter."""

from __future__ import annotations

import array
from enum import Enum, IntEnum
from typing import Any

import yaml
from rcl_interfaces.msg import Parameter as ParameterMsg
from rcl_interfaces.msg import ParameterType, ParameterValue

PARAMETER_SEPARATOR_STRING = "."

_FIELDS = {
    ParameterType.PARAMETER_BOOL: "bool_value",
    ParameterType.PARAMETER_INTEGER: "integer_value",
    ParameterType.PARAMETER_DOUBLE: "double_value",
    ParameterType.PARAMETER_STRING: "string_value",
    ParameterType.PARAMETER_BYTE_ARRAY: "byte_array_value",
    ParameterType.PARAMETER_BOOL_ARRAY: "bool_array_value",
    ParameterType.PARAMETER_INTEGER_ARRAY: "integer_array_value",
    ParameterType.PARAMETER_DOUBLE_ARRAY: "double_array_value",
    ParameterType.PARAMETER_STRING_ARRAY: "string_array_value",
}
_SCALARS: dict[str, type] = {"BOOL": bool, "INTEGER": int, "DOUBLE": float, "STRING": str}
_ITEMS: dict[str, type] = {
    "BYTE_ARRAY": bytes,
    "BOOL_ARRAY": bool,
    "INTEGER_ARRAY": int,
    "DOUBLE_ARRAY": float,
    "STRING_ARRAY": str,
}
_LISTS = (list, tuple, array.array)


class Parameter:
    """A named value.

    `type_` is inferred from the value if it is not given. Raises TypeError if `type_` is not a Parameter.Type
    or no type fits the value, and ValueError if the two do not agree.

    >>> Parameter("rate", value=2.5).type_
    <Type.DOUBLE: 3>
    """

    class Type(IntEnum):
        """A parameter's type."""

        NOT_SET = ParameterType.PARAMETER_NOT_SET
        BOOL = ParameterType.PARAMETER_BOOL
        INTEGER = ParameterType.PARAMETER_INTEGER
        DOUBLE = ParameterType.PARAMETER_DOUBLE
        STRING = ParameterType.PARAMETER_STRING
        BYTE_ARRAY = ParameterType.PARAMETER_BYTE_ARRAY
        BOOL_ARRAY = ParameterType.PARAMETER_BOOL_ARRAY
        INTEGER_ARRAY = ParameterType.PARAMETER_INTEGER_ARRAY
        DOUBLE_ARRAY = ParameterType.PARAMETER_DOUBLE_ARRAY
        STRING_ARRAY = ParameterType.PARAMETER_STRING_ARRAY

        __str__ = Enum.__str__

        def __format__(self, spec: str) -> str:
            return format(str(self), spec)

        @classmethod
        def from_parameter_value(cls, parameter_value: Any) -> Parameter.Type:
            """Return the type of a value; TypeError if no type fits.

            >>> Parameter.Type.from_parameter_value([True, False])
            <Type.BOOL_ARRAY: 6>
            """
            if parameter_value is None:
                return cls.NOT_SET
            for name, kind in _SCALARS.items():
                if isinstance(parameter_value, kind):
                    return cls[name]
            if not isinstance(parameter_value, _LISTS):
                raise TypeError(f"The given value is not one of the allowed types '{parameter_value}'.")
            for name, kind in _ITEMS.items():
                if all(isinstance(item, kind) for item in parameter_value):
                    return cls[name]
            raise TypeError(f"The given value is not a list of one of the allowed types '{parameter_value}'.")

        def check(self, parameter_value: Any) -> bool:
            """Return whether a parameter of this type may hold the value."""
            if self is Parameter.Type.NOT_SET:
                return parameter_value is None
            if self.name in _SCALARS:
                return isinstance(parameter_value, _SCALARS[self.name])
            kind = _ITEMS[self.name]
            return isinstance(parameter_value, _LISTS) and all(
                isinstance(item, kind) for item in parameter_value
            )

    @classmethod
    def from_parameter_msg(cls, param_msg: ParameterMsg) -> Parameter:
        """Return the parameter that an rcl_interfaces/msg/Parameter describes."""
        type_ = Parameter.Type(value=param_msg.value.type)
        field = _FIELDS.get(param_msg.value.type)
        return cls(param_msg.name, type_, getattr(param_msg.value, field) if field else None)

    def __init__(self, name: str, type_: Parameter.Type | None = None, value: Any = None) -> None:
        if type_ is None:
            type_ = Parameter.Type.from_parameter_value(value)
        if not isinstance(type_, Parameter.Type):
            raise TypeError(f"type must be an instance of '{Parameter.Type!r}'")
        if not type_.check(value):
            raise ValueError(f"Type '{type_}' and value '{value}' do not agree")
        self._type_ = type_
        self._name = name
        self._value = value

    @property
    def name(self) -> str:
        """The parameter's full name, parts joined by dots."""
        return self._name

    @property
    def type_(self) -> Parameter.Type:
        """The parameter's type."""
        return self._type_

    @property
    def value(self) -> Any:
        """The value; None if it is not set."""
        return self._value

    def get_parameter_value(self) -> ParameterValue:
        """Return the value as rcl_interfaces/msg/ParameterValue."""
        message = ParameterValue(type=self._type_.value)
        if field := _FIELDS.get(self._type_.value):
            setattr(message, field, _fitting(self._type_, self._value))
        return message

    def to_parameter_msg(self) -> ParameterMsg:
        """Return the parameter as rcl_interfaces/msg/Parameter."""
        return ParameterMsg(name=self._name, value=self.get_parameter_value())


def _fitting(type_: Parameter.Type, value: Any) -> Any:
    """The value in the form of its message field: several numbers as an array of 8-byte items, other items as a list."""
    if type_ is Parameter.Type.INTEGER_ARRAY:
        return array.array("q", value)
    if type_ is Parameter.Type.DOUBLE_ARRAY:
        return array.array("d", value)
    return list(value) if type_.name in _ITEMS else value


def get_parameter_value(string_value: str) -> ParameterValue:
    """Guess the value of a word on the command line (plain YAML rules).

    >>> get_parameter_value("[1, 2]").integer_array_value
    array('q', [1, 2])
    """
    try:
        read = yaml.safe_load(string_value)
    except yaml.YAMLError:
        read = string_value
    types = (Parameter.Type.BOOL_ARRAY, Parameter.Type.INTEGER_ARRAY, Parameter.Type.DOUBLE_ARRAY)
    if isinstance(read, list):
        kinds = [type_ for type_ in (*types, Parameter.Type.STRING_ARRAY) if type_.check(read)]
        type_ = kinds[0] if kinds else Parameter.Type.STRING
        return Parameter("", type_, read if kinds else string_value).get_parameter_value()
    if isinstance(read, bool | int | float | str):
        return Parameter("", value=read).get_parameter_value()
    return Parameter("", value=string_value).get_parameter_value()


def parameter_value_to_python(parameter_value: ParameterValue) -> Any:
    """Return the plain value of an rcl_interfaces/msg/ParameterValue; RuntimeError for an unknown type.

    >>> parameter_value_to_python(ParameterValue(type=3, double_value=1.5))
    1.5
    """
    if parameter_value.type == ParameterType.PARAMETER_NOT_SET:
        return None
    if parameter_value.type not in _FIELDS:
        raise RuntimeError(f"unexpected parameter type {parameter_value.type}")
    value = getattr(parameter_value, _FIELDS[parameter_value.type])
    return list(value) if isinstance(value, _LISTS) else value


def parameter_dict_from_yaml_file(
    parameter_file: str,
    use_wildcard: bool = False,
    target_nodes: list[str] | None = None,
    namespace: str = "",
) -> dict[str, ParameterMsg]:
    """Return the parameters of a YAML file by name.

    `target_nodes` lists the nodes to read for (default: all), `use_wildcard` adds the values for `/**`, and
    `namespace` is prepended to every name. Raises RuntimeError if there are no values for the nodes.
    """
    with open(parameter_file, encoding="utf-8") as file:
        nodes = _nodes_of(yaml.safe_load(file) or {}, parameter_file)
    wanted = None if not target_nodes else [_absolute(node) for node in target_nodes]
    values: dict[str, Any] = {}
    if use_wildcard:
        values.update(nodes.get("/**", {}))
    for node, said in nodes.items():
        if node in wanted if wanted is not None else node != "/**":
            values.update(said)
    if not values:
        known = f"{parameter_file} has some for: {', '.join(nodes) or 'no node'}"
        raise RuntimeError(f"Param file does not contain any valid parameters ({known})")
    return _messages(values, namespace)


def _absolute(name: str) -> str:
    return name if name.startswith("/") else "/" + name


def _nodes_of(tree: Any, where: str, prefix: str = "") -> dict[str, dict[str, Any]]:
    """The values of each node in a file, by full node name."""
    if not isinstance(tree, dict):
        raise RuntimeError(f"{where}: expected node names with a 'ros__parameters' mapping below them")
    nodes: dict[str, dict[str, Any]] = {}
    for key, value in tree.items():
        name = prefix + _absolute(str(key))
        if not isinstance(value, dict):
            continue
        if isinstance(value.get("ros__parameters"), dict):
            nodes.setdefault(name, {}).update(_flat(value["ros__parameters"]))
        inner = {part: below for part, below in value.items() if part != "ros__parameters"}
        for node, said in _nodes_of(inner, where, name).items():
            nodes.setdefault(node, {}).update(said)
    return nodes


def _flat(tree: dict[Any, Any], prefix: str = "") -> dict[str, Any]:
    flat: dict[str, Any] = {}
    for key, value in tree.items():
        name = f"{prefix}{key}"
        if isinstance(value, dict):
            flat.update(_flat(value, name + PARAMETER_SEPARATOR_STRING))
        else:
            flat[name] = value
    return flat


def _messages(values: dict[str, Any], namespace: str) -> dict[str, ParameterMsg]:
    messages = {}
    for name, value in values.items():
        full = namespace + name
        messages[full] = ParameterMsg(name=full, value=get_parameter_value(yaml.safe_dump(value)))
    return messages
