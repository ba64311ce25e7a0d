"""An asyncio loop that runs on the session's clock.

Coroutines, futures, `asyncio.sleep` and `asyncio.wait` of a launch file run on it unchanged; on the
virtual clock their waits take no time. The loop is registered as the running loop only while callbacks
run, so it also works inside a notebook cell, where another loop is already running.
"""

from __future__ import annotations

import asyncio
import asyncio.events
import asyncio.tasks
import heapq
from collections import deque
from collections.abc import Callable
from contextvars import Context
from typing import TYPE_CHECKING, Any

from coursekit.processes import session

if TYPE_CHECKING:
    from rclpy.executors import Executor


class ClockLoop(asyncio.AbstractEventLoop):
    """Runs callbacks in the order in which they become due; waits with the session's events."""

    def __init__(self) -> None:
        self.__session = session.current()
        self.__wake = self.__session.clock.new_event()
        self.__ready: deque[asyncio.Handle] = deque()
        self.__timers: list[tuple[float, int, asyncio.TimerHandle]] = []
        self.__count = 0
        self.__stopping = False
        self.__running = False
        self.__closed = False
        self.__debug = False
        self.__failures: Callable[..., Any] | None = None

    def time(self) -> float:
        """Return the session's steady time in seconds."""
        seconds: float = self.__session.clock.steady() / 1e9
        return seconds

    def call_soon(  # type: ignore[override]
        self, callback: Callable[..., Any], *args: Any, context: Context | None = None
    ) -> asyncio.Handle:
        """Run a callback in the next iteration."""
        handle = asyncio.Handle(callback, args, self, context)
        self.__ready.append(handle)
        return handle

    def call_soon_threadsafe(  # type: ignore[override]
        self, callback: Callable[..., Any], *args: Any, context: Context | None = None
    ) -> asyncio.Handle:
        """Run a callback soon; this may be called from any thread or process of the session."""
        handle = self.call_soon(callback, *args, context=context)
        self.__wake.set()
        return handle

    def call_later(  # type: ignore[override]
        self, delay: float, callback: Callable[..., Any], *args: Any, context: Context | None = None
    ) -> asyncio.TimerHandle:
        """Run a callback after `delay` seconds."""
        return self.call_at(self.time() + delay, callback, *args, context=context)

    def call_at(  # type: ignore[override]
        self, when: float, callback: Callable[..., Any], *args: Any, context: Context | None = None
    ) -> asyncio.TimerHandle:
        """Run a callback at a steady time [s]."""
        handle = asyncio.TimerHandle(when, callback, args, self, context)
        self.__count += 1
        heapq.heappush(self.__timers, (when, self.__count, handle))
        return handle

    def _timer_handle_cancelled(self, handle: asyncio.TimerHandle) -> None:
        """Do nothing: a cancelled timer is dropped when it is due."""

    def create_future(self) -> asyncio.Future[Any]:
        """Return a new future of this loop."""
        return asyncio.Future(loop=self)

    def create_task(self, coro: Any, **kwargs: Any) -> asyncio.Task[Any]:
        """Start a coroutine."""
        return asyncio.Task(coro, loop=self, **kwargs)

    def run_in_executor(self, executor: Executor, func: Callable[..., Any], *args: Any) -> asyncio.Future[Any]:  # type: ignore[override]
        """Run a function in a separate execution context; the future gets its result or exception."""
        future = self.create_future()

        def work() -> None:
            try:
                result = func(*args)
            except BaseException as error:
                self.call_soon_threadsafe(_settle, future, None, error)
            else:
                self.call_soon_threadsafe(_settle, future, result, None)

        self.__session.spawn(work)
        return future

    def run_until_complete(self, future: Any) -> Any:
        """Run until a future or coroutine is done; return its result."""
        task = asyncio.ensure_future(future, loop=self)
        task.add_done_callback(self.__wake_up)
        self.__run(task.done)
        return task.result()

    def run_forever(self) -> None:
        """Run until `stop` is called."""
        self.__stopping = False
        self.__run(lambda: self.__stopping)

    def __wake_up(self, _: Any) -> None:
        self.__wake.set()

    def __run(self, finished: Callable[[], bool]) -> None:
        if self.__closed:
            raise RuntimeError("Event loop is closed")
        if self.__running:
            raise RuntimeError("This event loop is already running")
        self.__running = True
        try:
            while not finished():
                self.__take_due_timers()
                if not self.__ready:
                    self.__wait()
                    self.__take_due_timers()
                outer = _enter(self)
                try:
                    self.__run_ready(finished)
                finally:
                    _leave(*outer)
        finally:
            self.__running = False

    def __run_ready(self, finished: Callable[[], bool]) -> None:
        """Run due callbacks, iteration by iteration, until none is left."""
        while self.__ready and not finished():
            for _ in range(len(self.__ready)):
                handle = self.__ready.popleft()
                if not handle.cancelled():
                    handle._run()
            self.__take_due_timers()

    def __wait(self) -> None:
        """Wait until the next timer is due or another thread adds a callback."""
        while self.__timers and self.__timers[0][2].cancelled():
            heapq.heappop(self.__timers)
        timeout = max(0.0, self.__timers[0][0] - self.time()) if self.__timers else None
        self.__wake.wait(timeout)
        self.__wake.clear()

    def __take_due_timers(self) -> None:
        now = self.time() + 1e-9
        while self.__timers and self.__timers[0][0] <= now:
            handle = heapq.heappop(self.__timers)[2]
            if not handle.cancelled():
                self.__ready.append(handle)

    def stop(self) -> None:
        """End `run_forever` after this iteration."""
        self.__stopping = True
        self.__wake.set()

    def is_running(self) -> bool:
        """Return whether the loop is running."""
        return self.__running

    def is_closed(self) -> bool:
        """Return whether the loop was closed."""
        return self.__closed

    def close(self) -> None:
        """Drop all callbacks; the loop cannot run again."""
        self.__closed = True
        self.__ready.clear()
        self.__timers.clear()

    async def shutdown_asyncgens(self) -> None:
        """Do nothing: there is nothing to shut down."""

    async def shutdown_default_executor(self, timeout: float | None = None) -> None:
        """Do nothing: there is nothing to shut down."""

    def get_debug(self) -> bool:
        """Return whether asyncio's debug checks are on."""
        return self.__debug

    def set_debug(self, enabled: bool) -> None:
        """Switch asyncio's debug checks on or off."""
        self.__debug = enabled

    def set_exception_handler(self, handler: Callable[..., Any] | None) -> None:
        """Set the handler of exceptions that are never awaited."""
        self.__failures = handler

    def call_exception_handler(self, context: dict[str, Any]) -> None:
        """Report an exception that is never awaited; leftovers of a closed loop are not reported."""
        if self.__closed:
            return
        if self.__failures is not None:
            self.__failures(self, context)
        else:
            self.default_exception_handler(context)

    def default_exception_handler(self, context: dict[str, Any]) -> None:
        """Log the exception."""
        from .logging import get_logger

        get_logger("launch").error(context.get("message"), exc_info=context.get("exception"))


def _settle(future: asyncio.Future[Any], result: Any, error: BaseException | None) -> None:
    if future.done():
        return
    if error is not None:
        future.set_exception(error)
    else:
        future.set_result(result)


_swap_current_task: Callable[..., Any] | None = getattr(asyncio.tasks, "_swap_current_task", None)


def _enter(loop: ClockLoop) -> tuple[Any, Any]:
    """Make `loop` this thread's running loop; return the outer loop and its task, which `_leave` restores."""
    outer = asyncio.events._get_running_loop()
    task = _swap_current_task(outer, None) if outer is not None and _swap_current_task is not None else None
    asyncio.events._set_running_loop(loop)
    return outer, task


def _leave(outer: Any, task: Any) -> None:
    asyncio.events._set_running_loop(outer)
    if outer is not None and _swap_current_task is not None:
        _swap_current_task(outer, task)
