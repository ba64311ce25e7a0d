"""A matcher that selects events by name."""

from __future__ import annotations

from collections.abc import Callable

from ..event import Event


def event_named(name: str) -> Callable[[Event], bool]:
    """Return a function that accepts events with this name."""
    return lambda event: getattr(event, "name", None) == name
