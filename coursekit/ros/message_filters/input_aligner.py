"""A filter that passes messages of several inputs on in the order of their stamps."""

from __future__ import annotations

import heapq
import math
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from rclpy.duration import Duration

from .simple_filter import SimpleFilter, time_of


@dataclass
class QueueStatus:
    """What is known of one input."""

    active: bool
    queue_size: int
    msgs_processed: int
    msgs_dropped: int


class _Input(SimpleFilter):
    """The messages of one input that wait for their turn, and the callbacks for them. Times are in nanoseconds."""

    def __init__(self) -> None:
        super().__init__()
        self.waiting: list[tuple[int, int, Any]] = []
        """A heap of stamps, numbers in the order of arrival, and messages."""
        self.period = self.processed = self.dropped = 0
        self.active = False
        self._expected = 0

    def push(self, stamp: int, msg: Any) -> None:
        heapq.heappush(self.waiting, (stamp, self.processed + len(self.waiting), msg))

    def pop(self) -> None:
        _, _, msg = heapq.heappop(self.waiting)
        self.processed += 1
        self.signalMessage(msg)

    def due(self) -> float:
        """The stamp of its first message, or the earliest that its next one can have."""
        if self.waiting:
            stamp = self.waiting[0][0]
            self._expected = stamp + self.period
            self.active = True
            return stamp
        return self._expected if self.active else math.inf


class InputAligner(SimpleFilter):
    """Passes messages of several inputs on, to callbacks for each of them, in the order of their stamps.

    A message waits until each active input has a message, or is not due yet by its period; an input without messages
    for `timeout` after it was due is no longer active, until its next one. Messages that come too late are dropped.

    >>> from builtin_interfaces.msg import Time
    >>> from geometry_msgs.msg import PointStamped
    >>> left, right = SimpleFilter(), SimpleFilter()
    >>> aligner = InputAligner(Duration(seconds=1), left, right)
    >>> for index, name in enumerate(["left", "right"]):
    ...     connection = aligner.registerCallback(index, lambda msg, name: print(name, msg.header.stamp.sec), name)
    ...     aligner.setInputPeriod(index, Duration(seconds=1))
    >>> later, earlier = PointStamped(), PointStamped()
    >>> later.header.stamp, earlier.header.stamp = Time(sec=2), Time(sec=1)
    >>> left.signalMessage(later)
    >>> right.signalMessage(earlier)
    >>> aligner.dispatchMessages()
    right 1
    left 2
    """

    def __init__(self, timeout: Duration, *inputs: SimpleFilter, filters: Sequence[SimpleFilter] = ()) -> None:
        super().__init__()
        self.timeout = timeout
        self.name = ""
        self.lock = threading.RLock()
        self.event_queues: list[_Input] = []
        self.input_connections: list[tuple[SimpleFilter, int]] = []
        self.dispatch_timer: Any = None
        self._last_in = self._last_out = 0
        self.connectInput(*inputs, filters=filters)

    def connectInput(self, *inputs: SimpleFilter, filters: Sequence[SimpleFilter] = ()) -> None:
        """Use the outputs of these filters as inputs, in place of those before and their callbacks."""
        with self.lock:
            self.disconnectAll()
            sources = [*inputs, *filters]
            self.event_queues = [_Input() for _ in sources]
            self.input_connections = [
                (source, source.registerCallback(self.add, index)) for index, source in enumerate(sources)
            ]

    def disconnectAll(self) -> None:
        """Take no more messages from the inputs."""
        for source, connection in self.input_connections:
            source.unregisterCallback(connection)
        self.input_connections = []

    def registerCallback(self, index: int, callback: Callable[..., Any], *args: Any) -> int:  # type: ignore[override]
        """Call `callback(message, *args)` for the messages of one input."""
        return self.event_queues[index].registerCallback(callback, *args)

    def setInputPeriod(self, index: int, period: Duration) -> None:
        """Tell how much time lies at least between two messages of an input."""
        self.event_queues[index].period = period.nanoseconds

    def setName(self, name: str) -> None:
        """Give the aligner a name."""
        self.name = name

    def getName(self) -> str:
        """Its name; empty at first."""
        return self.name

    def getQueueStatus(self, index: int) -> QueueStatus:
        """How many messages of an input wait, were passed on, and came too late."""
        each = self.event_queues[index]
        return QueueStatus(each.active, len(each.waiting), each.processed, each.dropped)

    def setupDispatchTimer(self, node: Any, update_rate: Duration) -> None:
        """Pass messages on at this interval."""
        self.dispatch_timer = node.create_timer(update_rate.nanoseconds / 1e9, self.dispatchMessages)

    def add(self, msg: Any, queue_index: int) -> None:
        """Add a message of one input; `dispatchMessages` passes it on."""
        stamp = time_of(msg.header.stamp).nanoseconds
        with self.lock:
            each = self.event_queues[queue_index]
            if stamp < self._last_out:
                each.dropped += 1
                return
            self._last_in = max(self._last_in, stamp)
            each.push(stamp, msg)

    def dispatchMessages(self) -> None:
        """Pass on all messages whose turn it is."""
        with self.lock:
            while self.event_queues and self._step():
                pass

    def _step(self) -> bool:
        stamps = [each.due() for each in self.event_queues]
        first = min(stamps)
        each = self.event_queues[stamps.index(first)]
        if each.waiting:
            self._last_out = each.waiting[0][0]
            each.pop()
            return True
        if self._last_in - first < self.timeout.nanoseconds:
            return False
        each.active = False
        return True
