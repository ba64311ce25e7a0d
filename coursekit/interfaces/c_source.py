"""C source of messages, services and actions, under the names that rosidl_generator_c gives them."""

from __future__ import annotations

from collections.abc import Iterator

from coursekit.interfaces.c_functions import function_lines
from coursekit.interfaces.c_types import c_name, owner_type
from coursekit.interfaces.cpp_source import header_name, messages_of
from coursekit.interfaces.cpp_types import element_type, literal
from coursekit.interfaces.model import Constant, Field, FieldType, Interface, Message

_FILLER = Field(FieldType("uint8"), "structure_needs_at_least_one_member")
_PARTS = ("struct", "functions")
"""The inner headers of an interface."""


def c_headers(interface: Interface, kind: str) -> dict[str, str]:
    """Return the headers of an interface by name: its own, and rosidl's inner ones, which include it.

    >>> list(c_headers(Message("std_msgs", "msg", "Empty"), "msg"))
    ['std_msgs/msg/empty.h', 'std_msgs/msg/detail/empty__struct.h', 'std_msgs/msg/detail/empty__functions.h']
    """
    own = header_name(interface.name)
    path = f"{interface.package}/{kind}"
    inner = f'#pragma once\n#include "{path}/{own}.h"\n'
    return {f"{path}/{own}.h": _header(interface), **{f"{path}/detail/{own}__{part}.h": inner for part in _PARTS}}


def _header(interface: Interface) -> str:
    messages = messages_of(interface)
    own = {message.full_name for message in messages}
    nested = dict.fromkeys(base for message in messages for base in message.dependencies() if base not in own)
    return "\n".join([
        f"// Made by coursekit from {interface.full_name}: do not edit.",
        "#pragma once",
        '#include "rosidl_runtime_c/primitives_sequence.h"',
        '#include "rosidl_runtime_c/string.h"',
        *(f'#include "{p}/{k}/{header_name(n)}.h"' for p, k, n in (base.split("/") for base in nested)),
        *(line for message in messages for line in _message(message)),
        "",
    ])  # fmt: skip


def _message(message: Message) -> Iterator[str]:
    name, fields = c_name(message.full_name), message.fields or (_FILLER,)
    for constant in message.constants:
        yield _constant(name, constant)
    for field in fields:
        yield from _bounds(name, field)
    yield f"typedef struct {name}\n{{"
    yield from (f"  {_declared(field)};" for field in fields)
    yield f"}} {name};"
    yield from function_lines(name, fields)
    yield f"COURSEKIT_C_CREATE({name})\nCOURSEKIT_C_SEQUENCE({name})"


def _constant(owner: str, constant: Constant) -> str:
    value = literal(constant.type, constant.value)
    name = f"{owner}__{constant.name}"
    if constant.type.base == "string":
        return f"static const char * const {name} = {value};"
    if "int" in constant.type.base and "64" not in constant.type.base:
        return f"enum {{{name} = {value}}};"
    return f"static const {element_type(constant.type)} {name} = {value};"


def _bounds(owner: str, field: Field) -> Iterator[str]:
    if field.type.is_upper_bound:
        yield f"enum {{{owner}__{field.name}__MAX_SIZE = {field.type.size}}};"
    if field.type.string_bound:
        yield f"enum {{{owner}__{field.name}__MAX_STRING_SIZE = {field.type.string_bound}}};"


def _declared(field: Field) -> str:
    kind = owner_type(field.type) or element_type(field.type)
    return f"{kind} {field.name}[{field.type.size}]" if field.type.is_fixed else f"{kind} {field.name}"
