"""The error for launch files that cannot be read."""

from __future__ import annotations

from collections.abc import Sequence


class InvalidLaunchFileError(Exception):
    """Raised if a launch file cannot be loaded; contains the errors that occurred."""

    def __init__(self, extension: str = "", *, likely_errors: Sequence[BaseException] | None = None) -> None:
        self._extension = extension
        self._likely_errors = list(likely_errors or [])
        super().__init__(self.__text())

    def __text(self) -> str:
        lines = [f"\n - {type(error).__name__}: {error}" for error in self._likely_errors]
        if not self._extension or not lines:
            return "The launch file may have a syntax error, or its format is unknown" + "".join(lines)
        kind = f"when trying to load file of format [{self._extension}]:"
        if len(lines) == 1:
            return f"Caught exception {kind} {self._likely_errors[0]}"
        return f"Caught multiple exceptions {kind}" + "".join(lines)
