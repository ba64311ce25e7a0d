"""The last messages of a filter, by time."""

from __future__ import annotations

from typing import Any

from rclpy.time import Time

from .simple_filter import SimpleFilter, stamp_of


class Cache(SimpleFilter):
    """Keeps the last `cache_size` messages and passes each on; messages without a header only if `allow_headerless`."""

    def __init__(self, f: SimpleFilter, cache_size: int = 1, allow_headerless: bool = False) -> None:
        super().__init__()
        self.cache_size = cache_size
        self.cache_msgs: list[Any] = []
        self.cache_times: list[Time] = []
        self.allow_headerless = allow_headerless
        self.connectInput(f)

    def connectInput(self, f: SimpleFilter) -> None:
        """Use the output of `f` as input."""
        self.incoming_connection = f.registerCallback(self.add)

    def add(self, msg: Any) -> None:
        """Add a message and pass it on."""
        stamp = stamp_of(msg, self.allow_headerless, "message_filters_cache", "")
        if stamp is None:
            return
        self.cache_times.append(stamp)
        self.cache_msgs.append(msg)
        if len(self.cache_msgs) > self.cache_size:
            del self.cache_msgs[0], self.cache_times[0]
        self.signalMessage(msg)

    def getInterval(self, from_stamp: Time, to_stamp: Time) -> list[Any]:
        """The messages between two times, both included."""
        assert from_stamp <= to_stamp
        pairs = zip(self.cache_msgs, self.cache_times, strict=True)
        return [msg for msg, time in pairs if from_stamp <= time <= to_stamp]

    def getElemAfterTime(self, stamp: Time) -> Any:
        """The first message that is not before a time; None when there is none."""
        pairs = zip(self.cache_msgs, self.cache_times, strict=True)
        return next((msg for msg, time in pairs if time >= stamp), None)

    def getElemBeforeTime(self, stamp: Time) -> Any:
        """The last message that is not after a time; None when there is none."""
        pairs = zip(reversed(self.cache_msgs), reversed(self.cache_times), strict=True)
        return next((msg for msg, time in pairs if time <= stamp), None)

    def getLastestTime(self) -> Time | None:
        """The time of the last message."""
        return self.cache_times[-1] if self.cache_times else None

    def getLatestTime(self) -> Time | None:
        """The time of the last message, under its correctly spelt name."""
        return self.getLastestTime()

    def getOldestTime(self) -> Time | None:
        """The time of the oldest message in the cache."""
        return self.cache_times[0] if self.cache_times else None

    def getLast(self) -> Any:
        """The last message."""
        latest = self.getLastestTime()
        return None if latest is None else self.getElemAfterTime(latest)
