"""Forms for messages: the control for each field, and the conversion of typed input back into a message."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import yaml

from coursekit.words.gettext import gettext

from .errors import BadArgument

_WHOLE = {"int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", "octet", "byte", "char"}


def schema(kind: Any) -> list[dict[str, Any]]:
    """Describe each field of a message class: name, type, control ('check', 'whole', 'number', 'text', 'list', 'group').

    >>> from geometry_msgs.msg import Point
    >>> schema(Point)[0]
    {'name': 'x', 'type': 'double', 'control': 'number', 'value': '0.0'}
    """
    blank = kind()
    types = kind.get_fields_and_field_types()
    return [
        _field(name, types[name], slot, getattr(blank, name))
        for name, slot in zip(types, kind.SLOT_TYPES, strict=True)
        if name != "structure_needs_at_least_one_member"
    ]


def _field(name: str, type_name: str, slot: Any, value: Any) -> dict[str, Any]:
    field: dict[str, Any] = {"name": name, "type": type_name}
    if hasattr(value, "get_fields_and_field_types"):
        return field | {"control": "group", "fields": schema(type(value))}
    if isinstance(value, bool):
        return field | {"control": "check", "value": value}
    if hasattr(slot, "value_type"):
        return field | {"control": "list", "value": _list_text(value)}
    if getattr(slot, "typename", "") in _WHOLE:
        return field | {
            "control": "whole",
            "value": str(int.from_bytes(value, "big") if isinstance(value, bytes) else value),
        }
    if isinstance(value, float):
        return field | {"control": "number", "value": repr(value)}
    limit = getattr(slot, "maximum_size", None)
    return field | {"control": "text", "value": str(value)} | ({"limit": limit} if limit else {})


def _list_text(values: Any) -> str:
    plain = [_plain(value) for value in values]
    return yaml.safe_dump(plain, default_flow_style=True, width=10**6).strip()


def _plain(value: Any) -> Any:
    if hasattr(value, "get_fields_and_field_types"):
        from rosidl_runtime_py import message_to_ordereddict

        return dict(message_to_ordereddict(value))
    return value.item() if hasattr(value, "item") else value


def filled(message: Any, typed: dict[str, Any]) -> Any:
    """Fill `message` with the typed values; ValueError names the field whose value does not fit.

    >>> from geometry_msgs.msg import Twist
    >>> filled(Twist(), {"linear": {"x": "0.5"}}).linear.x
    0.5
    """
    from rosidl_runtime_py import set_message_fields

    set_message_fields(message, _values(schema(type(message)), typed, ""))
    return message


def _values(fields: list[dict[str, Any]], typed: dict[str, Any], prefix: str) -> dict[str, Any]:
    known = {field["name"]: field for field in fields}
    for name in typed:
        if name not in known:
            raise BadArgument(f"There is no field '{prefix}{name}'. There are: {', '.join(known) or 'none'}")
    return {name: _value(known[name], value, prefix + name) for name, value in typed.items()}


def _value(field: dict[str, Any], value: Any, path: str) -> Any:
    control = field["control"]
    if control == "group":
        if hasattr(value, "get_fields_and_field_types"):
            return value
        return _values(field["fields"], value, f"{path}.")
    if not isinstance(value, str) or control == "text":
        return value
    try:
        readers: dict[str, Callable[[str], Any]] = {"whole": int, "number": float, "list": _list, "check": _truth}
        return readers[control](value)
    except (ValueError, yaml.YAMLError):
        wanted = {
            "whole": gettext("a whole number"),
            "number": gettext("a number"),
            "list": gettext("a list such as [1, 2]"),
            "check": gettext("true or false"),
        }
        raise BadArgument(f"{path}: '{value}' is not {wanted[control]}") from None


def _list(text: str) -> list[Any]:
    values = yaml.safe_load(text)
    if not isinstance(values, list):
        raise ValueError(text)
    return values


def _truth(text: str) -> bool:
    return {"true": True, "false": False}[text.lower()] if text.lower() in ("true", "false") else _refuse(text)


def _refuse(text: str) -> bool:
    raise ValueError(text)


__all__ = ["filled", "schema"]
