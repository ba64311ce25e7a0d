"""Futures, and tasks that run functions and coroutines in an executor."""

from __future__ import annotations

import inspect
import sys
import threading
import traceback
import weakref
from collections.abc import Callable, Generator
from contextvars import ContextVar
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rclpy._executor_work import Work

_in_task: ContextVar[bool] = ContextVar("rclpy_in_task", default=False)


class Future:
    """The result of an operation that may not be finished yet; it can be awaited.

    >>> future = Future()
    >>> future.set_result(42)
    >>> future.result()
    42
    """

    def __init__(self, *, executor: Work | None = None) -> None:
        self._done = False
        self._cancelled = False
        self._result: Any = None
        self._exception: BaseException | None = None
        self._exception_fetched = False
        self._callbacks: list[Callable[[Any], Any]] = []
        self._resumptions: list[Callable[[Any], None]] = []
        self._lock = threading.Lock()
        self._executor: Any = None
        self._set_executor(executor)

    def __del__(self) -> None:
        if getattr(self, "_exception", None) is not None and not self._exception_fetched:
            print(f"The following exception was never retrieved: {self._exception}", file=sys.stderr)

    def __await__(self) -> Generator[Future | None, None, Any]:
        while not self._done:
            yield self if _in_task.get() else None  # asyncio and `coroutine.send(None)` accept only a bare yield
        return self.result()

    def cancel(self) -> None:
        """Cancel the future unless it is done."""
        with self._lock:
            if not self._done:
                self._cancelled = True
        self._run_callbacks()

    def cancelled(self) -> bool:
        """Whether the future was cancelled."""
        return self._cancelled

    def done(self) -> bool:
        """Whether there is a result or an exception."""
        return self._done

    def result(self) -> Any:
        """The result; None while not done. Raises the exception if one was set."""
        if self._exception is not None:
            raise self.exception()  # type: ignore[misc]
        return self._result

    def exception(self) -> BaseException | None:
        """The exception, or None."""
        self._exception_fetched = True
        return self._exception

    def set_result(self, result: Any) -> None:
        """Finish with a result."""
        with self._lock:
            self._result = result
            self._done = True
            self._cancelled = False
        self._run_callbacks()

    def set_exception(self, exception: BaseException) -> None:
        """Finish with an exception."""
        with self._lock:
            self._exception = exception
            self._exception_fetched = False
            self._done = True
            self._cancelled = False
        self._run_callbacks()

    def add_done_callback(self, callback: Callable[[Any], Any]) -> None:
        """Call `callback(future)` when done, or at once if the future is already done.

        >>> future = Future()
        >>> future.add_done_callback(lambda future: print("result:", future.result()))
        >>> future.set_result(3)
        result: 3
        """
        with self._lock:
            pending = not self._done
            if pending:
                self._callbacks.append(callback)
        if not pending:
            self._call(callback)

    def remove_done_callback(self, callback: Callable[[Any], Any]) -> bool:
        """Remove a callback; return whether it was registered."""
        with self._lock:
            if callback not in self._callbacks:
                return False
            self._callbacks.remove(callback)
            return True

    def _set_executor(self, executor: Work | None) -> None:
        self._executor = None if executor is None else weakref.ref(executor)

    def _run_callbacks(self) -> None:
        with self._lock:
            callbacks, self._callbacks = self._callbacks, []
            resumptions, self._resumptions = self._resumptions, []
        for resume in resumptions:
            resume(self)
        for callback in callbacks:
            self._call(callback)

    def _call(self, callback: Callable[[Any], Any]) -> None:
        executor = self._executor() if self._executor is not None else None
        if executor is not None:
            executor.create_task(callback, self)
            return
        try:
            callback(self)
        except Exception as error:
            print(f"Unhandled exception in done callback: {error}", file=sys.stderr)
            traceback.print_exc()


class Task(Future):
    """Runs a function or a coroutine, step by step, when called."""

    def __init__(
        self,
        handler: Any,
        args: list[Any] | tuple[Any, ...] | None = None,
        kwargs: dict[str, Any] | None = None,
        executor: Work | None = None,
    ) -> None:
        super().__init__(executor=executor)
        self._handler = handler
        self._args = args or ()
        self._kwargs = kwargs or {}
        if inspect.iscoroutinefunction(handler):
            self._handler = handler(*self._args, **self._kwargs)
        self._coroutine = inspect.iscoroutine(self._handler)
        self._executing = False
        self._task_lock = threading.Lock()
        self.awaits: Future | None = None
        """The future that a coroutine waits for; None if it asked to be resumed as soon as possible."""

    def __call__(self) -> None:
        """Run until the task is done, or until its coroutine has to wait."""
        if self._done or self._cancelled or self._executing:
            return
        if not self._task_lock.acquire(blocking=False):
            return
        self._executing = True
        try:
            self._step()
        finally:
            self._executing = False
            self._task_lock.release()

    def _step(self) -> None:
        try:
            if not self._coroutine:
                result = self._handler(*self._args, **self._kwargs)
                if not inspect.iscoroutine(result):
                    self._finish(result)
                    return
                self._handler, self._coroutine = result, True
            self.awaits = self._resume()
        except StopIteration as stop:
            self._finish(stop.value)
        except Exception as error:
            self._complete()
            self.set_exception(error)

    def _resume(self) -> Future | None:
        token = _in_task.set(True)
        try:
            awaited: Future | None = self._handler.send(None)
            return awaited
        finally:
            _in_task.reset(token)

    def _finish(self, result: Any) -> None:
        self._complete()
        self.set_result(result)

    def _complete(self) -> None:
        self._handler = None
        self._args = ()
        self._kwargs = {}

    def executing(self) -> bool:
        """Whether the task is running now."""
        return self._executing

    def cancel(self) -> None:
        if self._coroutine and self._handler is not None and not self._executing:
            self._handler.close()
        super().cancel()
