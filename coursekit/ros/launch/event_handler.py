"""The base class of event handlers, and the general event handler."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from .event import Event
from .launch_description_entity import LaunchDescriptionEntity
from .some_entities_type import SomeEntitiesType

if TYPE_CHECKING:
    from .launch_context import LaunchContext


class BaseEventHandler:
    """Reacts to the events that `matcher` accepts; with `handle_once`, only to the first event."""

    _event_class: type = object
    """Only events of this class reach the matcher: a launch has hundreds of handlers, and each output line is an event."""
    _action: Any = None
    """If set, only events of this action reach the matcher."""

    def __init__(self, *, matcher: Callable[[Event], bool], handle_once: bool = False) -> None:
        if not isinstance(handle_once, bool):
            raise TypeError(f"'handle_once' expected to be 'bool', but got '{type(handle_once).__name__}'")
        self.__matcher = matcher
        self.__handle_once = handle_once

    @property
    def handle_once(self) -> bool:
        """Whether this handler unregisters itself after the first event."""
        return self.__handle_once

    @property
    def handler_description(self) -> str:
        """The handler's actions; subclasses override it."""
        return "{}"

    @property
    def matcher_description(self) -> str:
        """The events that the handler accepts; subclasses override it."""
        return "{}"

    def matches(self, event: Event) -> bool:
        """Return whether this handler accepts `event`."""
        return self.__matcher(event)

    def describe(self) -> tuple[str, list[SomeEntitiesType]]:
        """Return a description and the entities that this handler may return."""
        return (
            f"{type(self).__name__}(matcher='{self.matcher_description}', "
            f"handler='{self.handler_description}', handle_once={self.handle_once})"
        ), []

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """Put `event` into the context's locals; subclasses return the entities to visit next."""
        context.extend_locals({"event": event})
        if self.handle_once:
            context.unregister_event_handler(self)
        return None


class EventHandler(BaseEventHandler):
    """Visits given entities, or the entities that a function returns, on a matching event."""

    def __init__(
        self,
        *,
        matcher: Callable[[Event], bool],
        entities: SomeEntitiesType | Callable[..., SomeEntitiesType | None] | None = None,
        handle_once: bool = False,
        _event_class: type = object,
    ) -> None:
        super().__init__(matcher=matcher, handle_once=handle_once)
        self.__entities: Any = entities
        self._event_class = _event_class

    @property
    def entities(self) -> Any:
        """The entities that are visited when an event matches."""
        return self.__entities

    def describe(self) -> tuple[str, list[SomeEntitiesType]]:
        """Return a description and the entities that are known beforehand."""
        text, _ = super().describe()
        return text, as_entities(self.__entities)

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """Return the entities to visit for `event`."""
        super().handle(event, context)
        if callable(self.__entities):
            entities: SomeEntitiesType | None = self.__entities(event, context)
            return entities
        return as_entities(self.__entities)


def as_entities(some: Any) -> list[Any]:
    """Return entities as a list; an empty list for a function or None."""
    if some is None or callable(some):
        return []
    if isinstance(some, LaunchDescriptionEntity) or not isinstance(some, Iterable):
        return [some]
    return list(some)
