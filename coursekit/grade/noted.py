"""Work as a judge asks about it, with a note of what it raised and what its programs said last."""

from __future__ import annotations

from typing import Any

from .interruptions import TimeOver
from .outputs import exception_in


class NotedWork:
    """Work as a judge asks about it; what its programs said last is remembered, and what its functions raised."""

    def __init__(self, work: Any) -> None:
        self._work = work
        self._seen: Any = None
        self.raised: Exception | None = None
        """The last exception of a function of the student's."""

    def __getattr__(self, name: str) -> Any:
        return getattr(self._work, name)

    def function(self, name: str) -> Any:
        """A function of the student's; what it raises is theirs."""
        function = self._work.function(name)

        def called(*args: Any, **named: Any) -> Any:
            try:
                return function(*args, **named)
            except Exception as error:
                self.raised = error
                raise

        return called

    def timed_out(self) -> bool:
        """Whether the last function that failed did so because its time was over."""
        return isinstance(self.raised, TimeOver)

    def try_out(self, *commands: str, **plan: Any) -> Any:
        """Try out, and keep what was seen."""
        self._seen = None
        self._seen = self._work.try_out(*commands, **plan)
        return self._seen

    def death(self) -> str:
        """The exception that ended one of the programs that were tried out last; empty when none did."""
        outputs = getattr(self._seen, "outputs", [])
        return next((told for one in outputs if isinstance(one, str) and (told := exception_in(one))), "")
