"""A DiagnosticStatus with methods that fill it."""

from __future__ import annotations

from typing import Any

from diagnostic_msgs.msg import DiagnosticStatus, KeyValue

OK = DiagnosticStatus.OK


class DiagnosticStatusWrapper(DiagnosticStatus):
    """DiagnosticStatus with `summary`, `mergeSummary` and `add`.

    >>> status = DiagnosticStatusWrapper()
    >>> status.summary(DiagnosticStatus.WARN, "hot")
    >>> status.add("temperature", 81)
    >>> status.message, status.values[0].value
    ('hot', '81')
    """

    def __init__(self, *args: Any, **kwds: Any) -> None:
        super().__init__(*args, **kwds)

    def summary(self, *args: Any) -> None:
        """Set the level and the message, or copy those of another status."""
        self.level, self.message = _level_and_message(args)

    def clearSummary(self) -> None:
        """Reset to OK with an empty message."""
        self.summary(OK, "")

    def mergeSummary(self, *args: Any) -> None:
        """Take the worse of two levels. Join the messages if both levels are OK or neither is."""
        level, message = _level_and_message(args)
        if (level > OK) == (self.level > OK):
            self.message = "; ".join(text for text in (self.message, message) if text)
        elif level > self.level:
            self.message = message
        self.level = max(self.level, level)

    def add(self, key: str, value: Any) -> None:
        """Add a value with its key."""
        self.values = [*self.values, KeyValue(key=key, value=str(value))]


def _level_and_message(args: tuple[Any, ...]) -> tuple[bytes, str]:
    level, message = (args[0].level, args[0].message) if len(args) == 1 else args
    return (bytes([level]) if isinstance(level, int) else level), str(message)
