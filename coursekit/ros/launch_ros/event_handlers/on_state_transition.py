"""The handler for state changes of lifecycle nodes."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from launch.event import Event
from launch.event_handler import EventHandler
from launch.some_entities_type import SomeEntitiesType

from ..events.lifecycle import StateTransition

if TYPE_CHECKING:
    from ..actions.lifecycle_node import LifecycleNode


class OnStateTransition(EventHandler):
    """Visits entities on a transition of a lifecycle node; node, transition and states may restrict it."""

    def __init__(
        self,
        *,
        entities: SomeEntitiesType,
        target_lifecycle_node: LifecycleNode | None = None,
        matcher: Callable[[Event], bool] | None = None,
        transition: str | None = None,
        start_state: str | None = None,
        goal_state: str | None = None,
        **kwargs: Any,
    ) -> None:
        wanted = {"transition": transition, "start_state": start_state, "goal_state": goal_state}
        if matcher is not None and (target_lifecycle_node or any(wanted.values())):
            raise RuntimeError(
                "OnStateTransition takes either a matcher or the things it is to match, not both"
            )
        self.__target = target_lifecycle_node
        self.__wanted = {name: value for name, value in wanted.items() if value is not None}
        super().__init__(matcher=matcher or self.__wants, entities=entities, **kwargs)

    def __wants(self, event: Event) -> bool:
        if not isinstance(event, StateTransition):
            return False
        if self.__target is not None and event.action is not self.__target:
            return False
        return all(getattr(event, name) == value for name, value in self.__wanted.items())
