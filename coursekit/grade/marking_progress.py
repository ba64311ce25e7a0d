"""The progress of marking."""

from __future__ import annotations

import sys
import time

EVERY_S = 30.0
"""The period of progress lines without a terminal [s]."""


class Bar:
    """A progress bar on a terminal; occasional lines elsewhere."""

    def __init__(self) -> None:
        self._started = time.monotonic()
        self._told: float | None = None

    def say(self, line: str) -> None:
        """Print a step that precedes the marking."""
        print(line, file=sys.stderr, flush=True)

    def __call__(self, done: int, of: int, student: str) -> None:
        """Show the progress."""
        now = time.monotonic()
        left = (now - self._started) / done * (of - done)
        if sys.stderr.isatty():
            full = round(30 * done / of)
            line = f"\r{'█' * full}{'·' * (30 - full)} {done} of {of} notebooks, about {left:.0f} s left  {student[:20]:<20}"
            print(line, end="\n" if done == of else "", file=sys.stderr, flush=True)
        elif done == of or self._told is None or now - self._told >= EVERY_S:
            self._told = now
            rest = f", about {left:.0f} s left" if done < of else ""
            print(f"{done} of {of} notebooks marked{rest}", file=sys.stderr, flush=True)
