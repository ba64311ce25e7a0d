"""The handler that includes launch descriptions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

from ..event import Event
from ..event_handler import BaseEventHandler
from ..events import IncludeLaunchDescription
from ..some_entities_type import SomeEntitiesType

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class OnIncludeLaunchDescription(BaseEventHandler):
    """Visits the description of each IncludeLaunchDescription event."""

    _event_class = IncludeLaunchDescription

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(matcher=lambda event: isinstance(event, IncludeLaunchDescription), **kwargs)

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """Return the event's description."""
        super().handle(event, context)
        return cast(IncludeLaunchDescription, event).launch_description

    @property
    def matcher_description(self) -> str:
        """A description of the accepted events."""
        return "event issubclass of launch.events.IncludeLaunchDescription"
