"""The text of an interface definition, with the fields of nested messages indented below."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from . import api

_FIELD = re.compile(r"^\s*([A-Za-z][\w/]*)(<=\d+)?(\[[<=\d]*\])?\s+[A-Za-z]\w*")
_PRIMITIVES = {
    "bool", "byte", "char", "float32", "float64", "int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64",
    "string", "wstring",
}  # fmt: skip


def shown(name: str, comments: str = "top") -> Iterator[str]:
    """Yield the lines of an interface; `comments` is 'top' (as in the file itself), 'all' or 'none'.

    >>> list(shown("geometry_msgs/msg/Twist", "none"))[:2]
    ['Vector3  linear', '\\tfloat64 x']
    """
    yield from _expanded(_definition(name), name.split("/")[0], 0, comments)


def _definition(name: str) -> list[str]:
    from rosidl_runtime_py import get_interface_path

    try:
        return Path(get_interface_path(name)).read_text(encoding="utf-8").splitlines()
    except (LookupError, ValueError, OSError) as error:
        raise api.Unhappy(error.args[0] if len(error.args) == 1 else str(error)) from None


def _expanded(lines: list[str], package: str, depth: int, comments: str) -> Iterator[str]:
    for line in lines:
        keeps = comments == "all" or (comments == "top" and depth == 0)
        text = line.rstrip() if keeps else line.split("#")[0].rstrip() if not _holds_hash_in_string(line) else line
        if text.strip():
            yield "\t" * depth + text
        elif keeps:
            yield ""
        nested = _nested_type(line, package)
        if nested is not None:
            yield from _expanded(_definition(nested), nested.split("/")[0], depth + 1, comments)


def _holds_hash_in_string(line: str) -> bool:
    return bool(re.search(r"[\"'][^\"']*#[^\"']*[\"']", line))


def _nested_type(line: str, package: str) -> str | None:
    """Return the full name of a field's message type; None for primitives, constants and comments."""
    field = _FIELD.match(line.split("#")[0])
    if field is None or field[1] in _PRIMITIVES:
        return None
    parts = field[1].split("/")
    if len(parts) == 1:
        parts = [package, *parts]
    if parts[0] == "Header":
        parts = ["std_msgs", "Header"]
    return f"{parts[0]}/msg/{parts[-1]}"
