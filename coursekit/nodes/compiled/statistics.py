"""Topic statistics of a subscription: the age and period of its messages, published periodically."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from rclpy.clock import Clock, ClockType
from rclpy.qos import qos_profile_system_default
from statistics_msgs.msg import MetricsMessage, StatisticDataPoint, StatisticDataType

if TYPE_CHECKING:
    from rclpy.node import Node

    from coursekit.core.clock import Clock as SessionClock

_MS = 1e6
"""Nanoseconds per millisecond."""
_KINDS = (
    StatisticDataType.STATISTICS_DATA_TYPE_AVERAGE,
    StatisticDataType.STATISTICS_DATA_TYPE_MAXIMUM,
    StatisticDataType.STATISTICS_DATA_TYPE_MINIMUM,
    StatisticDataType.STATISTICS_DATA_TYPE_SAMPLE_COUNT,
    StatisticDataType.STATISTICS_DATA_TYPE_STDDEV,
)
"""In the order used by libstatistics_collector."""


class Samples:
    """The numbers of one time window.

    >>> samples = Samples()
    >>> for number in (2.0, 4.0): samples.add(number)
    >>> samples.summary()
    [3.0, 4.0, 2.0, 2.0, 1.0]
    """

    def __init__(self) -> None:
        self._values: list[float] = []

    def add(self, value: float) -> None:
        """Add a value."""
        self._values.append(value)

    def summary(self) -> list[float]:
        """Return average, maximum, minimum, count and standard deviation; NaN without values."""
        count = len(self._values)
        if not count:
            return [math.nan, math.nan, math.nan, 0.0, math.nan]
        average = sum(self._values) / count
        spread = math.sqrt(sum((value - average) ** 2 for value in self._values) / count)
        return [average, max(self._values), min(self._values), float(count), spread]


class TopicStatistics:
    """Collects statistics of a subscription's messages."""

    def __init__(self, node: Node, clock: SessionClock, topic: str, period: float) -> None:
        self._node, self._clock = node, clock
        self._publisher = node.create_publisher(MetricsMessage, topic, qos_profile_system_default)
        self._timer = node.create_timer(period, self._publish, clock=Clock(clock_type=ClockType.STEADY_TIME))
        self._last: int | None = None
        self._begin()

    def _begin(self) -> None:
        self._start = self._clock.now()
        self._ages, self._periods = Samples(), Samples()

    def hear(self, message: object) -> None:
        """Count a received message."""
        now = self._clock.now()
        if self._last is not None:
            self._periods.add((now - self._last) / _MS)
        self._last = now
        header = getattr(message, "header", None)
        sent = 0 if header is None else header.stamp.sec * 10**9 + header.stamp.nanosec
        if sent:
            self._ages.add((now - sent) / _MS)

    def _publish(self) -> None:
        for name, samples in (("message_age", self._ages), ("message_period", self._periods)):
            self._publisher.publish(self._metrics(name, samples))
        self._begin()

    def _metrics(self, name: str, samples: Samples) -> MetricsMessage:
        result = MetricsMessage(measurement_source_name=self._node.get_name(), metrics_source=name, unit="ms")
        for stamp, when in ((result.window_start, self._start), (result.window_stop, self._clock.now())):
            stamp.sec, stamp.nanosec = divmod(when, 10**9)
        pairs = zip(_KINDS, samples.summary(), strict=True)
        result.statistics = [StatisticDataPoint(data_type=kind, data=value) for kind, value in pairs]
        return result

    def destroy(self) -> None:
        """End the statistics."""
        self._node.destroy_timer(self._timer)
        self._node.destroy_publisher(self._publisher)
