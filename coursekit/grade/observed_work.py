"""A judge's view of the work, which records exceptions and the last output of programs."""

from __future__ import annotations

from typing import Any

from .interruptions import TimeOver
from .outputs import exception_in


class ObservedWork:
    """A judge's view of the work; it records the last output of its programs, and exceptions of its functions."""

    def __init__(self, work: Any) -> None:
        self._work = work
        self._seen: Any = None
        self.raised: Exception | None = None
        """The last exception of a student's function."""

    def __getattr__(self, name: str) -> Any:
        return getattr(self._work, name)

    def function(self, name: str) -> Any:
        """Return a student's function; its exceptions are attributed to the student."""
        function = self._work.function(name)

        def called(*args: Any, **named: Any) -> Any:
            try:
                return function(*args, **named)
            except Exception as error:
                self.raised = error
                raise

        return called

    def timed_out(self) -> bool:
        """Whether the last failed function exceeded its time."""
        return isinstance(self.raised, TimeOver)

    def try_out(self, *commands: str, **plan: Any) -> Any:
        """Run a trial, and record the observations."""
        self._seen = None
        self._seen = self._work.try_out(*commands, **plan)
        return self._seen

    def death(self) -> str:
        """Return the exception that ended a program of the last trial; empty when none did."""
        outputs = getattr(self._seen, "outputs", [])
        return next((told for output in outputs if isinstance(output, str) and (told := exception_in(output))), "")
