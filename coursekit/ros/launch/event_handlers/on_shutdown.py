"""The handler for the end of the launch."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from ..event import Event
from ..event_handler import BaseEventHandler, as_entities
from ..events import Shutdown
from ..some_entities_type import SomeEntitiesType

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class OnShutdown(BaseEventHandler):
    """Visits entities, or calls a function of (event, context), when the launch ends."""

    _event_class = Shutdown

    def __init__(
        self,
        *,
        on_shutdown: SomeEntitiesType | Callable[..., SomeEntitiesType | None],
        **kwargs: Any,
    ) -> None:
        super().__init__(matcher=lambda event: isinstance(event, Shutdown), **kwargs)
        self.__on_shutdown: Any = on_shutdown

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """Return the entities to visit now."""
        super().handle(event, context)
        if callable(self.__on_shutdown):
            entities: SomeEntitiesType | None = self.__on_shutdown(event, context)
            return entities
        return as_entities(self.__on_shutdown)

    def describe(self) -> tuple[str, list[SomeEntitiesType]]:
        """Return a description and the entities that are known beforehand."""
        text, _ = super().describe()
        return text, as_entities(self.__on_shutdown)

    @property
    def matcher_description(self) -> str:
        """A description of the accepted events."""
        return "event issubclass of launch.events.Shutdown"
