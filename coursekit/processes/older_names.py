"""Adds names to a library that it has dropped since the version of Humble's robots, for as long as sessions are open."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

Name = tuple[Any, str, Any]
"""A module or class, the name that it may lack, and the value."""


def adding(names: Callable[[], Iterable[Name]]) -> Callable[[Any], Callable[[], None]]:
    """Return the `make` of a Change that adds the names which are missing; what a library still has is its own.

    >>> import string
    >>> remove = adding(lambda: [(string, "letters", "abc"), (string, "digits", "x")])(None)
    >>> string.letters, string.digits
    ('abc', '0123456789')
    >>> remove()
    >>> hasattr(string, "letters")
    False
    """

    def add(_found: Any) -> Callable[[], None]:
        mine = [(owner, name, value) for owner, name, value in names() if name not in vars(owner)]
        for owner, name, value in mine:
            setattr(owner, name, value)
        return lambda: _remove(mine)

    return add


def _remove(names: list[Name]) -> None:
    for owner, name, value in names:
        if vars(owner).get(name) is value:
            delattr(owner, name)


__all__ = ["Name", "adding"]
