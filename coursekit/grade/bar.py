"""How far marking is, while it runs."""

from __future__ import annotations

import sys
import time


class Bar:
    """A progress bar on a terminal; a line now and then elsewhere."""

    def __init__(self) -> None:
        self._started = time.monotonic()

    def __call__(self, done: int, of: int, student: str) -> None:
        """Show how far it is."""
        left = (time.monotonic() - self._started) / done * (of - done)
        if sys.stderr.isatty():
            full = round(30 * done / of)
            line = f"\r{'█' * full}{'·' * (30 - full)} {done} of {of}, about {left:.0f} s left  {student[:20]:<20}"
            print(line, end="\n" if done == of else "", file=sys.stderr, flush=True)
        elif done == of or done % 10 == 0:
            print(f"{done} of {of} graded, about {left:.0f} s left", file=sys.stderr, flush=True)
