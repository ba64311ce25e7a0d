"""`ros2 run topic_tools relay`, `throttle`, `drop` and `delay`."""

from __future__ import annotations

from collections import deque
from typing import Any

from rclpy.clock import Clock
from rclpy.node import Node

from coursekit.nodes.topic_tools.tool import Tool, run_tool


class Throttle(Tool):
    """Limits the number of messages, or bytes, per second."""

    def __init__(self, given: dict[str, Any]) -> None:
        super().__init__("throttle", given)
        self._what = self.wanted("throttle_type", "messages")
        if self._what not in ("messages", "bytes"):
            raise ValueError(f"Unknown throttle type '{self._what}': give messages or bytes")
        if self._what == "messages":
            rate = self.wanted("msgs_per_sec", 0.0)
            if not rate > 0:
                raise ValueError(f"msgs_per_sec is {rate}: give a number above 0")
            self._period_ns = round(1e9 / rate)
        else:
            self._bytes, self._window_ns = self.wanted("bytes_per_sec", 0), round(self.wanted("window", 1.0) * 1e9)
        self._clock_used = Clock() if self.wanted("use_wall_clock", False) else self.get_clock()
        self._last_ns = self._clock_used.now().nanoseconds
        self._sent: deque[tuple[int, int]] = deque()

    def take(self, data: bytes) -> None:
        """Publish a message if the limit permits it."""
        now = self._clock_used.now().nanoseconds
        if self._may_go(now):
            self.say(data)
            self._last_ns = now
            self._sent.append((now, len(data)))

    def _may_go(self, now_ns: int) -> bool:
        if self._what == "messages":
            if now_ns < self._last_ns:
                self.get_logger().warning("Detected jump back in time, resetting throttle period to now for.")
                self._last_ns = now_ns
            self._sent.clear()
            return now_ns - self._last_ns >= self._period_ns
        while self._sent and self._sent[0][0] < now_ns - self._window_ns:
            self._sent.popleft()
        return sum(size for _, size in self._sent) < self._bytes


class Drop(Tool):
    """Drops X of every Y messages."""

    def __init__(self, given: dict[str, Any]) -> None:
        super().__init__("drop", given)
        self._dropped, self._of, self._count = self.wanted("X", 0), self.wanted("Y", 0), 0
        if self._of < 1 or self._dropped < 0:
            raise ValueError(f"X is {self._dropped} and Y {self._of}: of every Y messages X are dropped, for example 1 of 2")

    def take(self, data: bytes) -> None:
        """Drop a message if it is among the first X of Y."""
        if self._count >= self._dropped:
            self.say(data)
        self._count = (self._count + 1) % self._of


class Delay(Tool):
    """Publishes messages some seconds later."""

    def __init__(self, given: dict[str, Any]) -> None:
        super().__init__("delay", given)
        self._seconds = self.wanted("delay", 0.0)
        self._waiting: deque[tuple[int, bytes]] = deque()
        self._alarm: Any = None

    def take(self, data: bytes) -> None:
        """Store a message until it is due."""
        self._waiting.append((self.get_clock().now().nanoseconds + round(self._seconds * 1e9), data))
        if self._alarm is None:
            self._wait()

    def _wait(self) -> None:
        left = max(self._waiting[0][0] - self.get_clock().now().nanoseconds, 1)
        self._alarm = self.create_timer(left * 1e-9, self._ring)

    def _ring(self) -> None:
        self.destroy_timer(self._alarm)
        self._alarm = None
        while self._waiting and self._waiting[0][0] <= self.get_clock().now().nanoseconds:
            self.say(self._waiting.popleft()[1])
        if self._waiting:
            self._wait()


def _named(words: list[str], *names: str) -> dict[str, Any]:
    """Words on the command line by the names of their parameters."""
    return dict(zip(names, words, strict=False))


def relay(args: list[str] | None = None) -> int:
    """Run relay INTOPIC [OUTTOPIC]."""
    return run_tool(lambda words: Tool("relay", _named(words, "input_topic", "output_topic")), args)


def _throttle(words: list[str]) -> Node:
    if not words:
        return Throttle({})
    numbers: tuple[tuple[str, Any], ...] = (("msgs_per_sec", float),)
    if words[0] == "bytes":
        numbers = (("bytes_per_sec", int), ("window", float))
    given = _named(words, "throttle_type", "input_topic", *(name for name, _ in numbers), "output_topic")
    return Throttle(given | {name: kind(given[name]) for name, kind in numbers if name in given})


def throttle(args: list[str] | None = None) -> int:
    """Run throttle messages INTOPIC MSGS_PER_SEC [OUTTOPIC], or throttle bytes INTOPIC BYTES_PER_SEC WINDOW [OUTTOPIC]."""
    return run_tool(_throttle, args)


def _drop(words: list[str]) -> Node:
    given = _named(words, "input_topic", "X", "Y", "output_topic")
    return Drop(given | {name: int(given[name]) for name in ("X", "Y") if name in given})


def drop(args: list[str] | None = None) -> int:
    """Run drop INTOPIC X Y [OUTTOPIC]."""
    return run_tool(_drop, args)


def _delay(words: list[str]) -> Node:
    given = _named(words, "input_topic", "delay", "output_topic")
    return Delay(given | ({"delay": float(given["delay"])} if "delay" in given else {}))


def delay(args: list[str] | None = None) -> int:
    """Run delay INTOPIC SECONDS [OUTTOPIC]."""
    return run_tool(_delay, args)
