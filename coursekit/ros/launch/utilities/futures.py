"""Futures of the launch's loop."""

from __future__ import annotations

import asyncio
from typing import Any


def create_future(loop: asyncio.AbstractEventLoop | None) -> asyncio.Future[Any]:
    """Return a new future of `loop`, or of the current loop if it is None."""
    return (loop or asyncio.get_event_loop()).create_future()


def failed_future(loop: asyncio.AbstractEventLoop | None, error: BaseException) -> asyncio.Future[Any]:
    """Return a future of `loop` that has already failed; passed to a launch, it ends the launch with that error."""
    future = create_future(loop)
    future.set_exception(error)
    return future


def create_futures(loop: asyncio.AbstractEventLoop | None, count: int) -> list[asyncio.Future[Any]]:
    """Return `count` new futures of `loop`."""
    return [create_future(loop) for _ in range(count)]
