"""Interfaces by their names, for tab completion."""

from __future__ import annotations

from typing import Any

from rosidl_runtime_py import get_interfaces


def type_completer(**_: Any) -> list[str]:
    """All interfaces, for argcomplete.

    >>> "std_msgs/msg/String" in type_completer()
    True
    """
    return [f"{package}/{name}" for package, names in sorted(get_interfaces().items()) for name in sorted(names)]
