"""System signals, handled on an asyncio loop."""

from __future__ import annotations

import asyncio
import signal
import threading
from collections.abc import Callable
from types import TracebackType
from typing import Any

from coursekit.systems.signal_names import signal_called

Handler = Callable[[int], Any]


class AsyncSafeSignalManager:
    """Calls handlers on `loop` for the signals that arrive while the manager is entered.

    It works only in the main thread, as the system requires. In other threads, handlers are only stored; interrupts reach
    a launch through the session's processes.

    >>> import signal
    >>> manager = AsyncSafeSignalManager(asyncio.new_event_loop())
    >>> manager.handle(signal.SIGTERM, print) is None
    True
    """

    def __init__(self, loop: asyncio.AbstractEventLoop) -> None:
        self.__loop = loop
        self.__handlers: dict[int, Handler] = {}
        self.__previous: dict[int, Any] = {}
        self.__entered = False

    def __enter__(self) -> AsyncSafeSignalManager:
        self.__entered = True
        for signum in self.__handlers:
            self.__install(signum)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self.__entered = False
        for signum in list(self.__previous):
            self.__remove(signum)

    def handle(self, signum: int, handler: Handler | None) -> Handler | None:
        """Set the handler of `signum` (None removes it); return the previous handler."""
        signum = int(signum)
        before = self.__handlers.pop(signum, None)
        if handler is None:
            self.__remove(signum)
        else:
            self.__handlers[signum] = handler
            self.__install(signum)
        return before

    def __install(self, signum: int) -> None:
        main = threading.current_thread() is threading.main_thread()
        if self.__entered and main and signum not in self.__previous:
            self.__previous[signum] = signal.signal(signum, self.__on_signal)

    def __remove(self, signum: int) -> None:
        if signum in self.__previous:
            signal.signal(signum, self.__previous.pop(signum))

    def __on_signal(self, signum: int, frame: Any) -> None:
        handler = self.__handlers.get(signum)
        if handler is not None:
            self.__loop.call_soon_threadsafe(handler, signal_called(signum))
