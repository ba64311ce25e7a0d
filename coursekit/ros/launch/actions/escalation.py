"""Ensures that a process ends: SIGTERM after a timeout, then SIGKILL."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..action import Action
from ..events import matches_action
from ..events.process import SignalProcess
from ..launch_context import LaunchContext
from ..logging import get_logger
from ..substitution import Substitution
from ..substitutions import PythonExpression
from ..utilities import perform_substitutions
from .emit_event import EmitEvent
from .opaque_function import OpaqueFunction
from .timer_action import TimerAction

if TYPE_CHECKING:
    from .execute_local import ExecuteLocal


class Escalation:
    """Two timers that start when a process receives SIGINT."""

    def __init__(
        self, action: ExecuteLocal, sigterm_timeout: list[Substitution], sigkill_timeout: list[Substitution]
    ) -> None:
        self.__action = action
        both = PythonExpression(["float(", *sigterm_timeout, ") + float(", *sigkill_timeout, ")"])
        self.__timers = [
            self.__timer(sigterm_timeout, "SIGINT", "SIGTERM"),
            self.__timer([both], "SIGTERM", "SIGKILL"),
        ]

    def timers(self) -> list[Action]:
        """Return the timers to visit."""
        return [*self.__timers]

    def cancel(self) -> None:
        """Stop the timers: the process has ended."""
        for timer in self.__timers:
            timer.cancel()

    def __timer(self, timeout: list[Substitution], before: str, after: str) -> TimerAction:
        event = SignalProcess(signal_number=after, process_matcher=matches_action(self.__action))
        complaint = OpaqueFunction(function=self.__complain, args=[timeout, before, after])
        return TimerAction(
            period=timeout, actions=[complaint, EmitEvent(event=event)], cancel_on_shutdown=False
        )

    def __complain(
        self, context: LaunchContext, timeout: list[Substitution], before: str, after: str
    ) -> None:
        name = str(self.__action.process_description.final_name)
        get_logger(name).error(
            f"process[{name}] failed to terminate '{perform_substitutions(context, timeout)}' seconds "
            f"after receiving '{before}', escalating to '{after}'"
        )
