"""The complete definition of a message type as one text, as in mcap files: its own definition, then those of its parts."""

from __future__ import annotations

from coursekit.interfaces.errors import InterfaceError, UnknownInterface
from coursekit.interfaces.find import definition_text
from coursekit.interfaces.registry import interface_of

_LINE = "=" * 80


def full_definition(type_name: str) -> str:
    """Return the text; empty for a type that is not installed here.

    >>> print(full_definition("geometry_msgs/msg/PolygonStamped").count("MSG: "))
    4
    """
    try:
        names = _with_parts(type_name, [])
        texts = [definition_text(name) for name in names]
    except (UnknownInterface, InterfaceError, OSError):
        return ""
    parts = [f"{_LINE}\nMSG: {_short(name)}\n{text}" for name, text in zip(names[1:], texts[1:], strict=True)]
    return "\n".join([texts[0], *parts])


def _with_parts(name: str, names: list[str]) -> list[str]:
    names.append(name)
    for part in interface_of(name).dependencies():  # type: ignore[union-attr]
        if part not in names:
            _with_parts(part, names)
    return names


def _short(name: str) -> str:
    package, _, short = name.split("/")
    return f"{package}/{short}"
