"""Executes actions after a delay."""

from __future__ import annotations

import asyncio
import warnings
from collections.abc import Iterable
from typing import Any

from ..action import Action
from ..event import Event
from ..event_handler import EventHandler
from ..event_handlers import OnShutdown
from ..events import TimerEvent
from ..frontend import Entity, Parser, expose_action
from ..launch_context import LaunchContext
from ..launch_description_entity import LaunchDescriptionEntity
from ..some_substitutions_type import SomeSubstitutionsType
from ..utilities import ensure_argument_type, normalize_to_list_of_substitutions
from ..utilities.type_utils import normalize_typed_substitution, perform_typed_substitution


@expose_action("timer")
class TimerAction(Action):
    """Executes actions once, `period` seconds after it is visited, unless it is cancelled first.

    >>> from launch.actions import LogInfo
    >>> late = TimerAction(period=3.0, actions=[LogInfo(msg="three seconds later")])
    >>> late.actions[0].msg[0].text
    'three seconds later'
    """

    def __init__(
        self,
        *,
        period: float | SomeSubstitutionsType,
        actions: Iterable[LaunchDescriptionEntity],
        cancel_on_shutdown: bool | SomeSubstitutionsType = True,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        ensure_argument_type(actions, Iterable, "actions", "TimerAction")
        self.__period = normalize_typed_substitution(_seconds(period), float)
        self.__actions = list(actions)
        self.__cancel_on_shutdown = normalize_typed_substitution(cancel_on_shutdown, bool)
        self.__context_locals: dict[str, Any] = {}
        self.__completed: asyncio.Future[None] | None = None
        self.__alarm: asyncio.TimerHandle | None = None
        self.__canceled = False

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """Read `<timer period=>` with actions inside."""
        _, kwargs = super().parse(entity, parser)
        kwargs["period"] = parser.parse_if_substitutions(
            entity.get_attr("period", data_type=float, can_be_str=True)
        )
        kwargs["actions"] = [parser.parse_action(child) for child in entity.children]
        return cls, kwargs

    @property
    def period(self) -> Any:
        """The period in seconds, as a number or as substitutions."""
        return self.__period

    @property
    def actions(self) -> list[LaunchDescriptionEntity]:
        """The actions that are executed after the period."""
        return self.__actions

    def describe(self) -> str:
        """Return a description of the timer with its period."""
        return f"TimerAction(period={self.__period_text()}, actions=<actions>)"

    def __period_text(self) -> str:
        if isinstance(self.__period, float):
            return str(self.__period)
        return " + ".join(sub.describe() for sub in normalize_to_list_of_substitutions(self.__period))

    def describe_conditional_sub_entities(self) -> list[tuple[str, Iterable[LaunchDescriptionEntity]]]:
        """Return the actions that are executed after the period."""
        return [(f"{self.__period_text()} seconds pass without being canceled", self.__actions)]

    def handle(self, context: LaunchContext) -> list[LaunchDescriptionEntity]:
        """Return the actions to execute now."""
        context.extend_locals(self.__context_locals)
        return self.__actions

    def cancel(self) -> None:
        """Cancel the timer; this may also be called before it is visited and after it has fired."""
        self.__canceled = True
        if self.__alarm is not None:
            self.__alarm.cancel()
        if self.__completed is not None and not self.__completed.done():
            self.__completed.set_result(None)

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Start the timer on the launch's clock."""
        assert context.asyncio_loop is not None
        self.__completed = context.asyncio_loop.create_future()
        if self.__canceled:
            self.__completed.set_result(None)
            return None
        if perform_typed_substitution(context, self.__cancel_on_shutdown, bool):
            context.register_event_handler(OnShutdown(on_shutdown=self.__on_shutdown))
        context.register_event_handler(
            EventHandler(
                matcher=self.__is_mine,
                entities=lambda _, where: self.handle(where),
                handle_once=True,
                _event_class=TimerEvent,
            )
        )
        self.__context_locals = dict(context.get_locals_as_dict())
        self._start(context)
        return None

    def _start(self, context: LaunchContext) -> None:
        """Schedule `_fire` after the period; subclasses may use another clock."""
        assert context.asyncio_loop is not None
        delay = perform_typed_substitution(context, self.__period, float)
        self.__alarm = context.asyncio_loop.call_later(delay, self._fire, context)

    def __is_mine(self, event: Event) -> bool:
        return isinstance(event, TimerEvent) and event.timer_action is self

    def __on_shutdown(self, event: Event, context: LaunchContext) -> None:
        self.cancel()

    def _fire(self, context: LaunchContext) -> None:
        """Emit the event after the period."""
        context.emit_event_sync(TimerEvent(timer_action=self))
        if self.__completed is not None and not self.__completed.done():
            self.__completed.set_result(None)

    def get_asyncio_future(self) -> asyncio.Future[None] | None:
        """Return a future that is done when the timer has fired or is cancelled."""
        return self.__completed


def _seconds(period: float | SomeSubstitutionsType) -> float | SomeSubstitutionsType:
    """Return a literal text as a number; launch reads it, too, but it is deprecated."""
    if not isinstance(period, str):
        return period
    warnings.warn("TimerAction's 'period' is a float or a substitution; a text is deprecated", stacklevel=3)
    return float(period)
