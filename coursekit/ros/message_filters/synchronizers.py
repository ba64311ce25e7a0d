"""Synchronizers: messages of several filters with the same or nearly the same stamp."""

from __future__ import annotations

import itertools
import threading
from collections.abc import Sequence
from typing import Any

from rclpy.duration import Duration
from rclpy.time import Time

from .simple_filter import SimpleFilter, stamp_of, time_of

Queue = dict[int, Any]
"""Messages by their stamp in nanoseconds."""


class TimeSynchronizer(SimpleFilter):
    """Calls back with one message of each filter when all have the same stamp.

    Each filter's last `queue_size` messages wait for their partners.
    """

    def __init__(self, fs: Sequence[SimpleFilter], queue_size: int) -> None:
        super().__init__()
        self.queue_size = queue_size
        self.lock = threading.Lock()
        self.connectInput(fs)

    def connectInput(self, fs: Sequence[SimpleFilter]) -> None:
        """Use the outputs of these filters as inputs."""
        self.queues: list[Queue] = [{} for _ in fs]
        self.input_connections = [
            each.registerCallback(self.add, queue, number)
            for number, (each, queue) in enumerate(zip(fs, self.queues, strict=True))
        ]

    def add(self, msg: Any, my_queue: Queue, my_queue_index: int | None = None) -> None:
        """Add a message of one filter."""
        stamp = msg.header.stamp
        with self.lock:
            self._keep(my_queue, time_of(stamp), msg)
            for common in sorted(set.intersection(*(set(queue) for queue in self.queues))):
                self._release([common] * len(self.queues))

    def _keep(self, queue: Queue, stamp: Time, msg: Any) -> None:
        queue[stamp.nanoseconds] = msg
        while len(queue) > self.queue_size:
            del queue[min(queue)]

    def _release(self, stamps: Sequence[int]) -> None:
        pairs = list(zip(self.queues, stamps, strict=True))
        self.signalMessage(*[queue[stamp] for queue, stamp in pairs])
        for queue, stamp in pairs:
            del queue[stamp]


class ApproximateTimeSynchronizer(TimeSynchronizer):
    """Calls back with one message of each filter when their stamps lie within `slop` seconds.

    With `allow_headerless`, messages without a header are stamped on arrival; otherwise they are refused.
    With `sync_arrival_time`, the arrival time is used for all messages.

    >>> from builtin_interfaces.msg import Time
    >>> from message_filters import SimpleFilter
    >>> from sensor_msgs.msg import CameraInfo, Image
    >>> image, info = SimpleFilter(), SimpleFilter()
    >>> pairs = ApproximateTimeSynchronizer([image, info], queue_size=10, slop=0.1)
    >>> connection = pairs.registerCallback(lambda image, info: print("a pair"))
    >>> picture, camera = Image(), CameraInfo()
    >>> camera.header.stamp = Time(nanosec=50_000_000)  # 0.05 s later
    >>> image.signalMessage(picture)
    >>> info.signalMessage(camera)
    a pair
    """

    def __init__(
        self,
        fs: Sequence[SimpleFilter],
        queue_size: int,
        slop: float,
        allow_headerless: bool = False,
        sync_arrival_time: bool = False,
    ) -> None:
        super().__init__(fs, queue_size)
        self.slop = Duration(seconds=slop)
        self.allow_headerless = allow_headerless
        self.sync_arrival_time = sync_arrival_time

    def add(self, msg: Any, my_queue: Queue, my_queue_index: int | None = None) -> None:
        """Add a message of one filter."""
        asked = None if self.sync_arrival_time else msg
        allowed = self.allow_headerless or self.sync_arrival_time
        stamp = stamp_of(asked, allowed, "message_filters_approx", "for ")
        if stamp is None:
            return
        with self.lock:
            self._keep(my_queue, stamp, msg)
            mine = stamp.nanoseconds
            choices = []
            for number, queue in enumerate(self.queues):
                if number == my_queue_index:
                    choices.append([mine])
                    continue
                near = [other for other in queue if abs(other - mine) <= self.slop.nanoseconds]
                choices.append(sorted(near, key=lambda other: abs(other - mine)))
            self._match(choices)

    def _match(self, choices: Sequence[Sequence[int]]) -> None:
        """Release the first combination that lies within the slop, nearest stamps first."""
        for stamps in itertools.product(*choices):
            together = max(stamps) - min(stamps) < self.slop.nanoseconds
            if together and all(stamp in queue for queue, stamp in zip(self.queues, stamps, strict=True)):
                self._release(stamps)
                return
