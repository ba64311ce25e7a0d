"""Messages of Gazebo as people type them: `linear: {x: 0.5}, angular: {z: 0.1}`, the text format of protobuf."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cache
from typing import Any

from lark import Lark, Token, Tree
from lark.exceptions import UnexpectedInput

_GRAMMAR = r"""
start: field*
field: NAME (":" (_scalar | list) | ":"? block) ("," | ";")?
block: "{" field* "}" | "<" field* ">"
list: "[" (_scalar ("," _scalar)*)? "]"
_scalar: text | NUMBER | NAME
text: STRING+
NAME: /[A-Za-z_]\w*/
NUMBER: /[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?f?|-?inf\b|-?nan\b/
STRING: /"(\\.|[^"\\\n])*"|'(\\.|[^'\\\n])*'/
COMMENT: /#[^\n]*/
%ignore COMMENT
%ignore /[ \t\r\n]+/
"""
_NAMES = {"nsec": "nanosec"}
"""Fields of Gazebo's messages whose ROS names differ."""
_ESCAPES = {"n": "\n", "r": "\r", "t": "\t"}


class GzTextError(ValueError):
    """A text that is no message of its type; the message gives the reason."""


def fill(text: str, kind: str, *messages: Any) -> None:
    """Set the fields that a text gives in the ROS messages that stand for one message of Gazebo's type `kind`.

    Raises GzTextError for a text that is not in the format, and for unknown fields and values that do not fit.

    >>> from geometry_msgs.msg import Twist
    >>> msg = Twist()
    >>> fill("linear: {x: 0.5} angular { z: -1 }", "gz.msgs.Twist", msg)
    >>> msg.linear.x, msg.angular.z
    (0.5, -1.0)
    >>> fill("speed: 2", "gz.msgs.Twist", msg)  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    coursekit.nodes.gz.text_format.GzTextError: Message type "gz.msgs.Twist" has no field named "speed". It has: linear, ...
    """
    try:
        tree = _parser().parse(text)
    except UnexpectedInput as error:
        where = f"{max(error.line, 1)}:{max(error.column, 1)}"
        raise GzTextError(f"{where}: this is not 'name: value' or 'name {{...}}'") from None
    _fill(messages, tree, kind)


@cache
def _parser() -> Lark:
    return Lark(_GRAMMAR, parser="lalr")


def _fill(messages: Sequence[Any], block: Tree[Any], kind: str) -> None:
    owners = {name: message for message in messages for name in message.get_fields_and_field_types()}
    for field in block.children:
        told, value = str(field.children[0]), field.children[1]
        name = _NAMES.get(told, told)
        if name not in owners:
            raise GzTextError(f'Message type "{kind}" has no field named "{told}". It has: {", ".join(owners)}')
        if isinstance(value, Tree) and value.data == "block":
            _fill([_inner(getattr(owners[name], name), told, kind)], value, f"{kind}.{told}")
        else:
            _set(owners[name], name, value, f"{kind}.{told}")


def _inner(value: Any, name: str, kind: str) -> Any:
    if not hasattr(value, "get_fields_and_field_types"):
        raise GzTextError(f'"{name}" of "{kind}" has no fields: write {name}: value')
    return value


def _set(message: Any, name: str, value: Any, where: str) -> None:
    old = getattr(message, name)
    if hasattr(old, "get_fields_and_field_types"):
        raise GzTextError(f"{where} has fields: write {name}: {{{next(iter(old.get_fields_and_field_types()))}: ...}}")
    try:
        if isinstance(value, Tree) and value.data == "list":
            setattr(message, name, [_plain(message, each) for each in value.children])
        else:
            plain = _plain(message, value)
            if isinstance(plain, str) is not isinstance(old, str):
                raise ValueError("texts stand in quotes, and nothing else does")
            setattr(message, name, type(old)(plain))
    except (AssertionError, TypeError, ValueError, OverflowError) as error:
        raise GzTextError(f"{where}: {error}") from None


def _plain(message: Any, value: Any) -> Any:
    """Return the value of a text, a number, true, false, or a constant's name."""
    if isinstance(value, Tree):
        inside = "".join(str(part)[1:-1] for part in value.children)
        return re.sub(r"\\(.)", lambda sign: _ESCAPES.get(sign[1], sign[1]), inside)
    assert isinstance(value, Token)
    if value.type == "NUMBER":
        number = float(value.rstrip("f") if value.lower().strip("-") not in ("inf", "nan") else value)
        return int(number) if number.is_integer() else number
    if value in ("true", "false"):
        return value == "true"
    constant = getattr(type(message), value, None)
    if not isinstance(constant, int):
        raise ValueError(f"{value!s} is no value: a text stands in quotes")
    return constant


__all__ = ["GzTextError", "fill"]
