"""Python's `time` in a process, on the session's clock."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import Any

from .current_process import current_process

CLOCKS = ("time", "monotonic", "perf_counter", "time_ns", "monotonic_ns", "perf_counter_ns")
_real_clocks = {name: getattr(time, name) for name in CLOCKS}
_COMPILER = "numba"
"""It measures itself with thousands of clock readings per function, which must not count as polling."""


def _reader(name: str) -> Callable[[], Any]:
    real = _real_clocks[name]
    in_seconds = not name.endswith("_ns")
    is_system_time = name.startswith("time")

    def read() -> Any:
        process = current_process()
        if process is None or not process.session.clock.virtual:
            return real()
        clock = process.session.clock
        if sys._getframe(1).f_globals.get("__name__", "").partition(".")[0] != _COMPILER:
            clock.poll()
        nanoseconds = clock.now() if is_system_time else clock.steady()
        return nanoseconds / 1_000_000_000 if in_seconds else nanoseconds

    return read


_readers = {name: _reader(name) for name in CLOCKS}
monotonic = _readers["monotonic"]


def clock_reader(name: str) -> Callable[[Any], Any]:
    """Return the replacement of `time.NAME`, which reads the session's clock."""
    return lambda _real: _readers[name]
