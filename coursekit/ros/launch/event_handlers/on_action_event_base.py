"""The base class of handlers for events of actions."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from ..event import Event
from ..event_handler import BaseEventHandler, as_entities
from ..launch_description_entity import LaunchDescriptionEntity
from ..some_entities_type import SomeEntitiesType

if TYPE_CHECKING:
    from ..action import Action
    from ..launch_context import LaunchContext


class HandlerArgumentError(TypeError, ValueError):
    """Raised for a handler argument that is not an action, entity or function."""


class OnActionEventBase(BaseEventHandler):
    """Handles one kind of event of one action, or of all actions without a target.

    The target may be an action, or a function that accepts actions. The reaction may be entities, or a
    function of (event, context) that returns entities.
    """

    def __init__(
        self,
        *,
        action_matcher: Callable[[Action], bool] | Action | None,
        on_event: SomeEntitiesType | Callable[..., SomeEntitiesType | None] | None,
        target_event_cls: type[Event],
        target_action_cls: type[Action],
        **kwargs: Any,
    ) -> None:
        if (
            action_matcher is not None
            and not callable(action_matcher)
            and not isinstance(action_matcher, target_action_cls)
        ):
            raise HandlerArgumentError(
                f"{type(self).__name__} 'target_action' must be a {target_action_cls.__name__} or a "
                f"function, got {type(action_matcher).__name__}"
            )
        if not callable(on_event):
            _check_entities(type(self).__name__, as_entities(on_event))
        self.__target = action_matcher
        self.__wants_action: Any = action_matcher if callable(action_matcher) else None
        self._action = None if callable(action_matcher) else action_matcher
        self.__on_event: Any = on_event
        self.__target_event_cls = self._event_class = target_event_cls
        super().__init__(matcher=self.matches, **kwargs)

    def matches(self, event: Event) -> bool:
        """Return whether `event` is of that kind and of a target action."""
        if not isinstance(event, self.__target_event_cls):
            return False
        action = getattr(event, "action", None)
        if self.__wants_action is not None:
            return bool(self.__wants_action(action))
        return self.__target is None or action is self.__target

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """Return the entities to visit now."""
        super().handle(event, context)
        if callable(self.__on_event):
            entities: SomeEntitiesType | None = self.__on_event(event, context)
            return entities
        return as_entities(self.__on_event)

    def describe(self) -> tuple[str, list[SomeEntitiesType]]:
        """Return a description and the entities that are known beforehand."""
        text, _ = super().describe()
        return text, as_entities(self.__on_event)

    @property
    def handler_description(self) -> str:
        """A description of the handler's actions."""
        return "a function" if callable(self.__on_event) else f"{as_entities(self.__on_event)}"

    @property
    def matcher_description(self) -> str:
        """A description of the accepted events."""
        return f"event == {self.__target_event_cls.__name__} of {self.__target or 'any action'}"


def _check_entities(handler: str, entities: Iterable[Any]) -> None:
    for entity in entities:
        if not isinstance(entity, LaunchDescriptionEntity):
            raise HandlerArgumentError(
                f"{handler} expects actions or a function for what is to be done, got {type(entity).__name__}: {entity}"
            )
