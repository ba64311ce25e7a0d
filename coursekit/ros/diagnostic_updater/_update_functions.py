"""Tasks that monitor the frequency and the delay of events."""

from __future__ import annotations

import threading
from typing import Any

from diagnostic_msgs.msg import DiagnosticStatus
from rclpy.clock import Clock, ClockType
from rclpy.time import Time

from ._diagnostic_status_wrapper import DiagnosticStatusWrapper
from ._diagnostic_updater import DiagnosticTask


class FrequencyStatusParam:
    """Bounds {'min': Hz, 'max': Hz}, their relative tolerance (0.1: a tenth), and the window in reports."""

    def __init__(self, freq_bound: dict[str, float], tolerance: float = 0.1, window_size: int = 5) -> None:
        self.freq_bound, self.tolerance, self.window_size = freq_bound, tolerance, window_size


class FrequencyStatus(DiagnosticTask):
    """Monitors the frequency of the calls of `tick`."""

    def __init__(self, params: FrequencyStatusParam, name: str = "FrequencyStatus", clock: Clock | None = None) -> None:
        super().__init__(name)
        self.params, self.lock = params, threading.Lock()
        self.clock = clock or Clock(clock_type=ClockType.STEADY_TIME)
        self.clear()

    def clear(self) -> None:
        """Discard the recorded events."""
        with self.lock:
            self.count = 0
            now = self.clock.now()
            self.times = [now] * self.params.window_size
            self.seq_nums = [0] * self.params.window_size
            self.hist_indx = 0

    def tick(self) -> None:
        """Record an event."""
        with self.lock:
            self.count += 1

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        """Compare the frequency with the bounds."""
        with self.lock:
            now, place = self.clock.now(), self.hist_indx
            events, window = self.count - self.seq_nums[place], (now - self.times[place]).nanoseconds * 1e-9
            frequency = events / window if window > 0 else 0.0
            self.seq_nums[place], self.times[place] = self.count, now
            self.hist_indx = (place + 1) % self.params.window_size
            self._judge(stat, events, frequency)
            stat.add("Events in window", f"{events}")
            stat.add("Events since startup", f"{self.count}")
            stat.add("Duration of window (s)", f"{window:f}")
            stat.add("Actual frequency (Hz)", f"{frequency:f}")
            self._tell_bounds(stat)
        return stat

    def _judge(self, stat: DiagnosticStatusWrapper, events: int, frequency: float) -> None:
        low, high, tolerance = self.params.freq_bound["min"], self.params.freq_bound["max"], self.params.tolerance
        if not events:
            stat.summary(DiagnosticStatus.ERROR, "No events recorded.")
        elif frequency < low * (1 - tolerance):
            stat.summary(DiagnosticStatus.WARN, "Frequency too low.")
        elif "max" in self.params.freq_bound and frequency > high * (1 + tolerance):
            stat.summary(DiagnosticStatus.WARN, "Frequency too high.")
        else:
            stat.summary(DiagnosticStatus.OK, "Desired frequency met")

    def _tell_bounds(self, stat: DiagnosticStatusWrapper) -> None:
        low, high, tolerance = self.params.freq_bound["min"], self.params.freq_bound["max"], self.params.tolerance
        if low == high:
            stat.add("Target frequency (Hz)", f"{low:f}")
        if low > 0:
            stat.add("Minimum acceptable frequency (Hz)", f"{low * (1 - tolerance):f}")
        if high != float("inf"):
            stat.add("Maximum acceptable frequency (Hz)", f"{high * (1 + tolerance):f}")


class TimeStampStatusParam:
    """The range of acceptable ages of a stamp [s]; the age of a stamp in the future is negative."""

    def __init__(self, min_acceptable: float = -1, max_acceptable: float = 5) -> None:
        self.min_acceptable, self.max_acceptable = min_acceptable, max_acceptable


class TimeStampStatus(DiagnosticTask):
    """Monitors the age of the stamps passed to `tick`, in seconds or as rclpy's Time."""

    def __init__(
        self, params: TimeStampStatusParam | None = None, name: str = "Timestamp Status", clock: Clock | None = None
    ) -> None:
        super().__init__(name)
        self.params, self.clock = params or TimeStampStatusParam(), clock or Clock()
        self.lock = threading.Lock()
        self.early_count = self.late_count = self.zero_count = 0
        self.zero_seen, self.max_delta, self.min_delta, self.deltas_valid = False, 0.0, 0.0, False

    def tick(self, stamp: Any) -> None:
        """Record a stamp."""
        seconds = stamp.nanoseconds * 1e-9 if isinstance(stamp, Time) else float(stamp)
        with self.lock:
            if seconds == 0:
                self.zero_seen = True
                return
            delta = self.clock.now().nanoseconds * 1e-9 - seconds
            self.max_delta = max(self.max_delta, delta) if self.deltas_valid else delta
            self.min_delta = min(self.min_delta, delta) if self.deltas_valid else delta
            self.deltas_valid = True

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        """Compare the ages with the acceptable range, and reset them."""
        with self.lock:
            self._judge(stat)
            stat.add("Earliest timestamp delay:", f"{self.min_delta:f}")
            stat.add("Latest timestamp delay:", f"{self.max_delta:f}")
            stat.add("Earliest acceptable timestamp delay:", f"{self.params.min_acceptable:f}")
            stat.add("Latest acceptable timestamp delay:", f"{self.params.max_acceptable:f}")
            stat.add("Late diagnostic update count:", f"{self.late_count}")
            stat.add("Early diagnostic update count:", f"{self.early_count}")
            stat.add("Zero seen diagnostic update count:", f"{self.zero_count}")
            self.deltas_valid, self.min_delta, self.max_delta, self.zero_seen = False, 0.0, 0.0, False
        return stat

    def _judge(self, stat: DiagnosticStatusWrapper) -> None:
        stat.summary(DiagnosticStatus.OK, "Timestamps are reasonable.")
        if not self.deltas_valid:
            stat.summary(DiagnosticStatus.WARN, "No data since last update.")
            return
        if self.min_delta < self.params.min_acceptable:
            stat.summary(DiagnosticStatus.ERROR, "Timestamps too far in future seen.")
            self.early_count += 1
        if self.max_delta > self.params.max_acceptable:
            stat.summary(DiagnosticStatus.ERROR, "Timestamps too far in past seen.")
            self.late_count += 1
        if self.zero_seen:
            stat.summary(DiagnosticStatus.ERROR, "Zero timestamp seen.")
            self.zero_count += 1


class Heartbeat(DiagnosticTask):
    """Reports that the node is alive."""

    def __init__(self) -> None:
        super().__init__("Heartbeat")

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        """Set the status to OK."""
        stat.summary(DiagnosticStatus.OK, "Alive")
        return stat
