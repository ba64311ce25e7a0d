"""A status as it was heard last, and the names under which it is published."""

from __future__ import annotations

from dataclasses import dataclass, field

from diagnostic_msgs.msg import DiagnosticStatus, KeyValue

OK, WARN, ERROR, STALE = range(4)
WORDS = ("OK", "Warning", "Error", "Stale")
"""The messages of groups, by their levels."""


@dataclass
class Item:
    """A status; `heard_ns` is when it came [ns]. Without one it is missing, and stale."""

    name: str
    heard_ns: int
    level: int = STALE
    message: str = "Missing"
    hardware_id: str = ""
    values: list[KeyValue] = field(default_factory=list)

    @classmethod
    def of(cls, status: DiagnosticStatus, now_ns: int) -> Item:
        """Return the item of a message; a level that is not known counts as an error."""
        level = status.level[0]
        return cls(
            status.name, now_ns, level if level <= STALE else ERROR, status.message, status.hardware_id, list(status.values)
        )

    def to_status(self, path: str, *, stale: bool) -> DiagnosticStatus:
        """Return the message below a path."""
        status = status_of(f"{path.rstrip('/')}/{output_name(self.name)}", STALE if stale else self.level, self.message)
        status.hardware_id, status.values = self.hardware_id, self.values
        return status


def status_of(name: str, level: int, message: str = "") -> DiagnosticStatus:
    """Return a status; without a message that of its level."""
    return DiagnosticStatus(name=name, level=bytes([level]), message=message or WORDS[level])


def output_name(name: str) -> str:
    """Return a name that is one part of a path.

    >>> output_name("/arms/left")
    ' arms left'
    """
    return name.replace("/", " ")


def without_prefix(name: str, prefix: str) -> str:
    """Return a path whose last part does not begin with a prefix, a colon or spaces.

    >>> without_prefix("/Robot/hokuyo: Frequency", "hokuyo")
    '/Robot/Frequency'
    """
    if not prefix:
        return name
    head, slash, last = name.rpartition("/")
    return head + slash + last.removeprefix(prefix).removeprefix(":").lstrip(" ")


__all__ = ["ERROR", "OK", "STALE", "WARN", "WORDS", "Item", "output_name", "status_of", "without_prefix"]
