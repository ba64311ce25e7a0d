"""A judge's view of the work, which records exceptions and the last output of programs."""

from __future__ import annotations

from typing import Any

from .interruptions import TimeOver
from .outputs import exception_in

NOT_FOUND = "No executable found"
"""What `ros2 run` says."""


class ObservedWork:
    """A judge's view of the work; it records the last output of its programs, and exceptions of its functions."""

    def __init__(self, work: Any) -> None:
        self._work = work
        self._seen: Any = None
        self._commands: tuple[str, ...] = ()
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
        self._seen, self._commands = None, commands
        self._seen = self._work.try_out(*commands, **plan)
        return self._seen

    def death(self) -> str:
        """Return the exception that ended a program of the last trial; empty when none did."""
        outputs = getattr(self._seen, "outputs", [])
        return next((told for output in outputs if isinstance(output, str) and (told := exception_in(output))), "")

    def not_found(self) -> tuple[str, str] | None:
        """Return the package and name of an executable that `ros2 run` did not find in the last trial, if any."""
        outputs = getattr(self._seen, "outputs", [])
        for command, output in zip(self._commands, outputs, strict=False):
            words = command.split()
            if words[:1] == ["run"] and len(words) > 2 and isinstance(output, str) and NOT_FOUND in output.splitlines():
                return words[1], words[2]
        return None
