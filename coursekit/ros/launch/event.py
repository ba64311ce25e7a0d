"""The base class of all events."""

from __future__ import annotations


class Event:
    """An occurrence to which event handlers react."""

    name = "launch.Event"
