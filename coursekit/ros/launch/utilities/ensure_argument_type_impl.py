"""Checks an argument's type; the error names the expected type."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any


def ensure_argument_type(
    argument: Any,
    types: type | Iterable[type],
    argument_name: str,
    caller: str | None = None,
) -> None:
    """Raise TypeError unless `argument` is an instance of one of `types`.

    >>> ensure_argument_type(1, str, 'name', 'Node')
    Traceback (most recent call last):
    TypeError: Node 'name' expected to be '<class 'str'>', but got '1' of type '<class 'int'>'
    """
    wanted = list(types) if isinstance(types, Iterable) and not isinstance(types, type) else [types]
    if not all(isinstance(kind, type) for kind in wanted):
        expected = "type, collections.abc.Iterable of type"
        raise TypeError(f"'ensure_argument_type()' expected 'types' to be one of [{expected}], but got '{types}'")
    if isinstance(argument, tuple(wanted)):
        return
    phrase = f"one of {wanted}" if len(wanted) > 1 else f"'{wanted[0]}'"
    raise TypeError(
        f"{caller + ' ' if caller else ''}'{argument_name}' expected to be {phrase}, "
        f"but got '{argument}' of type '{type(argument)}'"
    )
