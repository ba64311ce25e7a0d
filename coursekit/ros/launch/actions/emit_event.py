"""Emits an event."""

from __future__ import annotations

from typing import Any

from ..action import Action
from ..event import Event
from ..launch_context import LaunchContext
from ..launch_description_entity import LaunchDescriptionEntity
from ..utilities import ensure_argument_type


class EmitEvent(Action):
    """Emits an event; handlers react to it after earlier events."""

    def __init__(self, *, event: Event, **kwargs: Any) -> None:
        ensure_argument_type(event, (Event,), "event", "EmitEvent")
        super().__init__(**kwargs)
        self.__event = event

    @property
    def event(self) -> Event:
        """The event."""
        return self.__event

    def describe(self) -> str:
        """Return the event's name."""
        return f"Emitting event '{self.__event.name}'"

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Emit the event."""
        context.emit_event_sync(self.__event)
        return None
