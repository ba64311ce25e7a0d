"""Unregisters an event handler."""

from __future__ import annotations

from typing import Any

from ..action import Action
from ..event_handler import BaseEventHandler
from ..launch_context import LaunchContext
from ..launch_description_entity import LaunchDescriptionEntity


class UnregisterEventHandler(Action):
    """Unregisters an event handler, which no longer reacts to events."""

    def __init__(self, event_handler: BaseEventHandler, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__event_handler = event_handler

    @property
    def event_handler(self) -> BaseEventHandler:
        """The event handler."""
        return self.__event_handler

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Unregister the handler."""
        context.unregister_event_handler(self.__event_handler)
        return None
