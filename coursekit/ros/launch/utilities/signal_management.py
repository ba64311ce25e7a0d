"""Kept for programs that install launch's signal manager themselves."""

from __future__ import annotations

from collections.abc import Callable
from types import TracebackType
from typing import Any


class AsyncSafeSignalManager:
    """Accepts signal handlers as launch's own does.

    Interrupts reach a launch through the session's processes, so there is nothing to install here:
    `handle` only remembers what was asked for.
    """

    def __init__(self, loop: Any = None) -> None:
        self.__handlers: dict[int, Callable[[int], None] | None] = {}

    def __enter__(self) -> AsyncSafeSignalManager:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self.__handlers.clear()

    def handle(self, signum: int, handler: Callable[[int], None] | None) -> Callable[[int], None] | None:
        """Remember `handler` for `signum`; return the one before it."""
        previous = self.__handlers.get(signum)
        self.__handlers[signum] = handler
        return previous
