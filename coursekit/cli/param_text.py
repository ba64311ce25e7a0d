"""The text forms of parameters: labelled values, descriptors, files."""

from __future__ import annotations

from typing import Any

import yaml

_KINDS = (
    ("not set", None),
    ("boolean", "Boolean value is:"),
    ("integer", "Integer value is:"),
    ("double", "Double value is:"),
    ("string", "String value is:"),
    ("byte array", "Byte values are:"),
    ("boolean array", "Boolean values are:"),
    ("integer array", "Integer values are:"),
    ("double array", "Double values are:"),
    ("string array", "String values are:"),
)
_FIELDS = (
    None,
    "bool_value",
    "integer_value",
    "double_value",
    "string_value",
    "byte_array_value",
    "bool_array_value",
    "integer_array_value",
    "double_array_value",
    "string_array_value",
)


def type_name(number: int) -> str:
    """Return the name of a parameter type.

    >>> type_name(2)
    'integer'
    """
    return _KINDS[number][0]


def labelled(value: Any) -> tuple[str | None, Any]:
    """Return the label of a ParameterValue and the value itself; (None, None) when it is not set.

    >>> from rcl_interfaces.msg import ParameterValue
    >>> labelled(ParameterValue(type=3, double_value=0.5)), labelled(ParameterValue())
    (('Double value is:', 0.5), (None, None))
    """
    field = _FIELDS[value.type]
    return (None, None) if field is None else (_KINDS[value.type][1], getattr(value, field))


def described(descriptor: Any) -> str:
    """Format a ParameterDescriptor as lines.

    >>> from rcl_interfaces.msg import ParameterDescriptor
    >>> print(described(ParameterDescriptor(name="serial", type=4, read_only=True)))
    Parameter name: serial
      Type: string
      Constraints:
        Read only: true
    """
    lines = [f"Parameter name: {descriptor.name}", f"  Type: {type_name(descriptor.type)}"]
    if descriptor.description:
        lines.append(f"  Description: {descriptor.description}")
    lines.append("  Constraints:")
    if descriptor.read_only:
        lines.append("    Read only: true")
    for allowed in [*descriptor.floating_point_range, *descriptor.integer_range]:
        lines += [f"    Min value: {allowed.from_value}", f"    Max value: {allowed.to_value}"]
        if allowed.step:
            lines.append(f"    Step: {allowed.step}")
    if descriptor.additional_constraints:
        lines.append(f"    Additional constraints: {descriptor.additional_constraints}")
    return "\n".join(lines)


def dumped(node: str, names: list[str], values: list[Any]) -> str:
    """Return the YAML file of a node's parameters; dots in names become levels.

    >>> from rcl_interfaces.msg import ParameterValue
    >>> print(dumped("/camera", ["image.width"], [ParameterValue(type=2, integer_value=640)]), end="")
    /camera:
      ros__parameters:
        image:
          width: 640
    """
    tree: dict[str, Any] = {}
    for name, value in zip(names, values, strict=True):
        field = _FIELDS[value.type]
        if field is None:
            continue
        plain = getattr(value, field)
        *above, last = name.split(".")
        branch = tree
        for level in above:
            branch = branch.setdefault(level, {})
        branch[last] = list(plain) if value.type > 4 else plain
    return yaml.safe_dump({node: {"ros__parameters": tree}}, default_flow_style=False)
