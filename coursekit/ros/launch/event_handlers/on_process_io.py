"""The handler for a process's input and output."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from ..events.process import ProcessIO
from ..some_entities_type import SomeEntitiesType
from .on_action_event_base import OnActionEventBase

if TYPE_CHECKING:
    from ..actions.execute_local import ExecuteLocal
    from ..launch_context import LaunchContext

Reaction = Callable[[ProcessIO], "SomeEntitiesType | None"]


class OnProcessIO(OnActionEventBase):
    """Calls a function with each ProcessIO event of a process, one function for each stream."""

    def __init__(
        self,
        *,
        target_action: ExecuteLocal | Callable[[ExecuteLocal], bool] | None = None,
        on_stdin: Reaction | None = None,
        on_stdout: Reaction | None = None,
        on_stderr: Reaction | None = None,
        **kwargs: Any,
    ) -> None:
        from ..actions.execute_local import ExecuteLocal

        self.__reactions = (on_stdin, on_stdout, on_stderr)
        super().__init__(
            action_matcher=target_action,  # type: ignore[arg-type]
            on_event=self.__react,
            target_event_cls=ProcessIO,
            target_action_cls=ExecuteLocal,
            **kwargs,
        )

    def __react(self, event: ProcessIO, context: LaunchContext) -> SomeEntitiesType | None:
        streams = (event.from_stdin, event.from_stdout, event.from_stderr)
        reaction = self.__reactions[streams.index(True)]
        return None if reaction is None else reaction(event)
