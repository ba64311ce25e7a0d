"""Messages as YAML, comma-separated values and dictionaries."""

from __future__ import annotations

import array
import sys
from collections import OrderedDict
from typing import Any

import yaml
from rosidl_parser import definition

Options = dict[str, Any]


class _Dumper(yaml.Dumper):
    """Keeps the order of an OrderedDict."""


def _represent(dumper: yaml.Dumper, data: OrderedDict[str, Any]) -> yaml.MappingNode:
    items = [(dumper.represent_data(k), dumper.represent_data(v)) for k, v in data.items()]
    return yaml.MappingNode("tag:yaml.org,2002:map", items)


_Dumper.add_representer(OrderedDict, _represent)


def message_to_yaml(
    msg: Any,
    *,
    truncate_length: int | None = None,
    no_arr: bool = False,
    no_str: bool = False,
    flow_style: bool = False,
) -> str:
    """Return a message as YAML.

    >>> from geometry_msgs.msg import Point
    >>> print(message_to_yaml(Point(x=1.0)), end='')
    x: 1.0
    y: 0.0
    z: 0.0
    """
    values = message_to_ordereddict(msg, truncate_length=truncate_length, no_arr=no_arr, no_str=no_str)
    text: str = yaml.dump(
        values, Dumper=_Dumper, allow_unicode=True, width=sys.maxsize, default_flow_style=flow_style
    )
    return text


def message_to_ordereddict(
    msg: Any, *, truncate_length: int | None = None, no_arr: bool = False, no_str: bool = False
) -> OrderedDict[str, Any]:
    """Return the fields of a message and of the messages in it, in order; for a serialized message, its bytes."""
    if isinstance(msg, bytes):
        return OrderedDict(bytes=msg)
    options = {"truncate_length": truncate_length, "no_arr": no_arr, "no_str": no_str}
    fields = zip(field_names(msg), msg.SLOT_TYPES, strict=True)
    return OrderedDict((name, _plain(getattr(msg, name), kind, options)) for name, kind in fields)


def _convert_value(
    value: Any,
    *,
    field_type: definition.AbstractType | None = None,
    truncate_length: int | None = None,
    no_arr: bool = False,
    no_str: bool = False,
) -> Any:
    """Return a field's value as numbers, texts, lists and dictionaries.

    >>> _convert_value((1, 2, 3), truncate_length=2)
    (1, 2, '...')
    """
    return _plain(value, field_type, {"truncate_length": truncate_length, "no_arr": no_arr, "no_str": no_str})


def _plain(value: Any, kind: definition.AbstractType | None, options: Options) -> Any:
    limit = options["truncate_length"]
    if isinstance(value, (bool, int, float)):
        return value
    if isinstance(value, bytes):
        text = "".join(map(chr, value[:limit]))
        return text + "..." if len(value) > len(text) else text
    if isinstance(value, str):
        return _plain_text(value, options)
    if _is_collection(value):
        return _plain_collection(value, kind, options)
    if isinstance(value, dict):
        return {
            _plain(k, None, {**options, "truncate_length": None}): _plain(v, None, options)
            for k, v in value.items()
        }
    return message_to_ordereddict(value, **options)


def _plain_text(value: str, options: Options) -> str:
    limit = options["truncate_length"]
    if options["no_str"]:
        return f"<string length: <{len(value)}>>"
    return value[:limit] + "..." if limit is not None and len(value) > limit else value


def _is_collection(value: Any) -> bool:
    return isinstance(value, (list, tuple, array.array)) or type(value).__name__ == "ndarray"


def _plain_collection(value: Any, kind: definition.AbstractType | None, options: Options) -> Any:
    limit = options["truncate_length"]
    if options["no_arr"] and isinstance(kind, definition.AbstractNestedType):
        return _abbreviated(value, kind)
    items = value[:limit]
    shown = [_plain(item, None, options) for item in (items.tolist() if hasattr(items, "tolist") else items)]
    if len(value) > len(shown):
        shown.append("...")
    return tuple(shown) if isinstance(value, tuple) else shown


def _type_name(kind: definition.AbstractType) -> str:
    if isinstance(kind, definition.BasicType):
        return kind.typename
    if isinstance(kind, definition.NamespacedType):
        return "/".join(kind.namespaced_name())
    return "wstring" if isinstance(kind, definition.AbstractWString) else "string"


def _abbreviated(value: Any, kind: definition.AbstractNestedType) -> str:
    name = _type_name(kind.value_type)
    if isinstance(kind, definition.Array):
        return f"<array type: {name}[{kind.size}]>"
    bound = f"[{kind.maximum_size}]" if isinstance(kind, definition.BoundedSequence) else ""
    return f"<sequence type: {name}{bound}, length: {len(value)}>"


def message_to_csv(
    msg: Any, *, truncate_length: int | None = None, no_arr: bool = False, no_str: bool = False
) -> str:
    """Return a message as comma-separated values.

    >>> from geometry_msgs.msg import Quaternion
    >>> message_to_csv(Quaternion())
    '0.0,0.0,0.0,1.0'
    """
    if isinstance(msg, bytes):
        return str(msg)
    options = {"truncate_length": truncate_length, "no_arr": no_arr, "no_str": no_str}
    fields = zip(field_names(msg), msg.SLOT_TYPES, strict=True)
    return ",".join(_csv(getattr(msg, name), kind, options) for name, kind in fields)


def _csv(value: Any, kind: definition.AbstractType | None, options: Options) -> str:
    limit = options["truncate_length"]
    if _is_collection(value):
        if options["no_arr"] and isinstance(kind, definition.AbstractNestedType):
            return _abbreviated(value, kind)
        shown = [_csv(item, None, options) for item in value[:limit]]
        return ",".join([*shown, "..."] if len(value) > len(shown) else shown)
    if isinstance(value, str):
        return _plain_text(value, options)
    if isinstance(value, bytes) and limit is not None and len(value) > limit:
        return str(value[:limit] + b"...")
    return message_to_csv(value, **options) if hasattr(value, "SLOT_TYPES") else str(value)


def field_names(msg: Any) -> list[str]:
    """Return the names of a message's fields; for a class of a program's own without them, the names of its slots."""
    if hasattr(msg, "get_fields_and_field_types"):
        return list(msg.get_fields_and_field_types())
    return [slot.removeprefix("_") for slot in msg.__slots__]


def get_message_slot_types(msg: Any) -> OrderedDict[str, definition.AbstractType]:
    """Return the type of each field."""
    return OrderedDict(zip(field_names(msg), msg.SLOT_TYPES, strict=True))
