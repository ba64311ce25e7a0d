"""The event loop of a thread."""

from __future__ import annotations

import asyncio
import threading

__all__ = ["asyncio", "get_loop"]

_own = threading.local()


def get_loop() -> asyncio.AbstractEventLoop:
    """Return this thread's own event loop; create one if there is none or it was closed.

    >>> get_loop() is get_loop()
    True
    """
    loop: asyncio.AbstractEventLoop | None = getattr(_own, "loop", None)
    if loop is None or loop.is_closed():
        loop = _own.loop = asyncio.new_event_loop()
        asyncio.set_event_loop(loop)
    return loop
