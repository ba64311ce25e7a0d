"""An event handler for a text that a process prints when it is ready."""

from __future__ import annotations

from typing import Any

from launch.actions import ExecuteProcess
from launch.event_handlers import OnProcessIO
from launch.events.process import ProcessIO
from launch.some_entities_type import SomeEntitiesType


class StdoutReadyListener(OnProcessIO):
    """Executes `actions` when `target_action`, or any process, prints `ready_txt` to its standard output."""

    def __init__(
        self, *, target_action: ExecuteProcess | None = None, ready_txt: str, actions: list[SomeEntitiesType]
    ) -> None:
        self.__ready_txt = ready_txt
        self.__actions = actions
        super().__init__(target_action=target_action, on_stdout=self.__on_stdout)

    def __on_stdout(self, event: ProcessIO) -> Any:
        return self.__actions if self.__ready_txt in event.text.decode() else None

    def describe(self) -> tuple[str, list[SomeEntitiesType]]:
        """Return a description and the actions."""
        return super().describe()[0], self.__actions
