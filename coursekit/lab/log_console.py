"""The log lines of nodes: /rosout with filters."""

from __future__ import annotations

import itertools
from collections import Counter, deque
from typing import TYPE_CHECKING, Any

from .errors import BadArgument
from .panel import Panel, static

if TYPE_CHECKING:
    from builtin_interfaces.msg import Time
    from rcl_interfaces.msg import Log

KEPT = 2000
"""How many lines the console keeps."""
SENT = 300
"""How many lines the browser shows at most: the newest that pass the filters."""
LEVELS = {10: "DEBUG", 20: "INFO", 30: "WARN", 40: "ERROR", 50: "FATAL"}
_NUMBERS = {name: number for number, name in LEVELS.items()}


class LogConsole(Panel):
    """See `log_console`."""

    _esm = static("log.js")
    _css = static("log.css")

    def __init__(self, level: str = "DEBUG", node: str = "", text: str = "") -> None:
        from rcl_interfaces.msg import Log
        from rclpy.qos import DurabilityPolicy, QoSProfile

        if level not in _NUMBERS:
            raise BadArgument(f"There is no level '{level}'. Levels are: {', '.join(_NUMBERS)}")
        super().__init__("log_console")
        self._filters = {"level": level, "node": node.strip("/").replace("/", "."), "text": text}
        self._entries: deque[Log] = deque(maxlen=KEPT)
        self._counts: Counter[str] = Counter()
        self._paused: list[Log] | None = None
        qos = QoSProfile(depth=1000, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.hidden.node.create_subscription(Log, "/rosout", self._collect, qos)

    def _collect(self, entry: Log) -> None:
        self._entries.append(entry)
        self._counts[LEVELS.get(entry.level, "INFO")] += 1
        self.changed()

    # -- from code

    def filter(self, level: str | None = None, node: str | None = None, text: str | None = None) -> None:
        """Show only this level and above, this node, or lines containing this text; None leaves a filter unchanged."""
        for name, value in (("level", level), ("node", node), ("text", text)):
            if value is not None:
                self._filters[name] = value
        self.changed()

    def pause(self, on: bool = True) -> None:
        """Freeze the displayed lines; collecting continues."""
        self._paused = list(self._entries) if on else None
        self.changed()

    def clear(self) -> None:
        """Delete all lines."""
        self._entries.clear()
        self._counts.clear()
        self._paused = None if self._paused is None else []
        self.changed()

    def lines(self) -> list[str]:
        """The lines that pass the filters, oldest first."""
        return [f"[{LEVELS.get(entry.level, 'INFO')}] [{entry.name}]: {entry.msg}" for entry in self._passing()]

    def _passing(self) -> list[Log]:
        least, node, text = _NUMBERS[self._filters["level"]], self._filters["node"], self._filters["text"].lower()
        kept = list(self._entries) if self._paused is None else self._paused
        kept = sorted(
            kept, key=lambda entry: (entry.stamp.sec, entry.stamp.nanosec)
        )  # a late subscriber gets them node by node
        return [entry for entry in kept if entry.level >= least and node in ("", entry.name) and text in entry.msg.lower()]

    # -- what is shown

    def text(self) -> str:
        """Return the counts and the last ten lines."""
        counts = ", ".join(f"{self._counts[name]} {name}" for name in _NUMBERS if self._counts[name])
        return "\n".join([f"log: {counts or 'nothing yet'}", *self.lines()[-10:]])

    def shown(self) -> dict[str, Any]:
        """Return the newest lines, the counts and the filters."""
        passing = self._passing()
        return {
            "lines": [
                {
                    "level": LEVELS.get(entry.level, "INFO"),
                    "node": entry.name,
                    "text": entry.msg,
                    "time": _clock_time(entry.stamp),
                    "place": f"{entry.file}:{entry.line} {entry.function}".strip(": "),
                }
                for entry in itertools.islice(passing, max(0, len(passing) - SENT), None)
            ],
            "passing": len(passing),
            "counts": {name: self._counts[name] for name in _NUMBERS},
            "nodes": sorted({entry.name for entry in list(self._entries)}),
            "filters": self._filters,
            "paused": self._paused is not None,
        }

    def on_filter(self, message: dict[str, Any]) -> None:
        """Handle a changed filter."""
        level = message.get("level")
        self.filter(level if level in _NUMBERS else None, message.get("node"), message.get("text"))
        self._push()

    def on_pause(self, message: dict[str, Any]) -> None:
        """Handle the pause button."""
        self.pause(bool(message.get("on")))
        self._push()

    def on_clear(self, _message: dict[str, Any]) -> None:
        """Handle the clear button."""
        self.clear()
        self._push()


def _clock_time(stamp: Time) -> str:
    """Format a UTC time from hours to milliseconds."""
    seconds = stamp.sec % 86400
    return f"{seconds // 3600:02}:{seconds // 60 % 60:02}:{seconds % 60:02}.{stamp.nanosec // 1_000_000:03}"


def log_console(level: str = "DEBUG", node: str = "", text: str = "") -> LogConsole:
    """Show the log lines of nodes, with filters by level, node and text.

    >>> %ros2 run demo_nodes_py talker &
    [talker: running]
    >>> console = log_console(node="talker")
    >>> wait(2.5)
    >>> console
    log: 2 INFO
    [INFO] [talker]: Publishing: "Hello World: 0"
    [INFO] [talker]: Publishing: "Hello World: 1"

    In ROS 2: `ros2 topic echo /rosout`, or rqt's console.
    """
    return LogConsole(level, node, text)


__all__ = ["LogConsole", "log_console"]
