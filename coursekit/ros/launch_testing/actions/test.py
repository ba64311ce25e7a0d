"""An action that runs a test program as part of a launch."""

from __future__ import annotations

from typing import Any

from launch.actions import EmitEvent, ExecuteProcess, TimerAction
from launch.events import matches_action
from launch.events.process import SignalProcess
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType


class Test(ExecuteProcess):
    """Starts a test program, and kills it after `timeout` seconds if it still runs."""

    __test__ = False  # pytest: this is not a test case

    def __init__(self, *, timeout: float | SomeSubstitutionsType | None = None, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__timeout = timeout

    @property
    def timeout(self) -> float | SomeSubstitutionsType | None:
        """Seconds after which the program is killed; None for never."""
        return self.__timeout

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Start the program and the timer that kills it."""
        actions = super().execute(context)
        if not self.__timeout:
            return actions
        kill = SignalProcess(signal_number="SIGKILL", process_matcher=matches_action(self))
        return [*(actions or []), TimerAction(period=self.__timeout, actions=[EmitEvent(event=kill)])]
