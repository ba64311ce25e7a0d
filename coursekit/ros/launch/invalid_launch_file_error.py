"""The error that says why a launch file could not be read."""

from __future__ import annotations

from collections.abc import Sequence


class InvalidLaunchFileError(Exception):
    """Raised when a launch file cannot be loaded; holds what went wrong on the way."""

    def __init__(self, extension: str = "", *, likely_errors: Sequence[BaseException] | None = None) -> None:
        self._extension = extension
        self._likely_errors = list(likely_errors or [])
        super().__init__(self.__text())

    def __text(self) -> str:
        kind = f"file of format [{self._extension}]" if self._extension else "launch file of unknown format"
        if not self._likely_errors:
            return f"Failed to load {kind}"
        if len(self._likely_errors) == 1:
            return f"Caught exception when trying to load {kind}: {self._likely_errors[0]}"
        lines = [f"\n - {type(error).__name__}: {error}" for error in self._likely_errors]
        return f"Caught multiple exceptions when trying to load {kind}:" + "".join(lines)
