"""Waiting for files, as asyncio's loops do: on the session's clock, and interruptible by Ctrl-C."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from coursekit.core.clock import waited_ns

from .current_process import current_process

STEP = 0.02
"""Polling interval for the files [s]."""


def patient(real: Callable[..., Any]) -> Callable[..., Any]:
    """Wrap a selector's `select` for a process of a session: on the virtual clock the others run while it waits."""

    def select(self: Any, timeout: float | None = None) -> Any:
        process = current_process()
        if process is None or (timeout is not None and timeout <= 0):
            return real(self, timeout)
        clock = process.session.clock
        end = None if timeout is None else clock.steady() + waited_ns(timeout)
        while True:
            left = STEP if end is None else min(STEP, (end - clock.steady()) / 1e9)
            ready = real(self, 0 if clock.virtual else max(0.0, left))
            if ready or left <= 0:
                return ready
            if clock.virtual:
                clock.sleep(left)

    return select
