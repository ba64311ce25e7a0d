"""Executors: they wait for ready entities and run their callbacks."""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from coursekit.core.execution_context import CallbackAbandoned, ProcessKilled
from coursekit.processes.session import current
from rclpy._executor_base import Executor
from rclpy._executor_work import (
    _POLL_WEIGHT,
    ConditionReachedException,
    ExternalShutdownException,
    ShutdownException,
    TimeoutException,
    TimeoutObject,
    await_or_execute,
    deadline_of,
    never,
)
from rclpy._lent import lender
from rclpy._thread_pool import ThreadPool
from rclpy.task import Future

if TYPE_CHECKING:
    from rclpy.context import Context

__getattr__ = lender(__name__)  # names that programs import from here

__all__ = [
    "ConditionReachedException",
    "Executor",
    "ExternalShutdownException",
    "MultiThreadedExecutor",
    "ShutdownException",
    "SingleThreadedExecutor",
    "TimeoutException",
    "TimeoutObject",
    "await_or_execute",
]

_ONE_THREAD = "MultiThreadedExecutor is used with a single thread.\nUse the SingleThreadedExecutor instead."


class SingleThreadedExecutor(Executor):
    """Runs callbacks one after the other in the thread that spins.

    >>> other = rclpy.create_node("other")
    >>> executor = rclpy.executors.SingleThreadedExecutor()
    >>> executor.add_node(node), executor.add_node(other)
    (True, True)
    >>> timer = other.create_timer(1.0, lambda: print("tick of the other node"))
    >>> executor.spin_once()
    tick of the other node
    """

    def __init__(self, *, context: Context | None = None) -> None:
        super().__init__(context=context)

    def _spin_once(self, timeout_sec: float | TimeoutObject | None, condition: Callable[[], bool]) -> None:
        try:
            entity, work = self._next_work(timeout_sec, condition)
        except (ShutdownException, TimeoutException, ConditionReachedException):
            return
        self._run(entity, work)

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Wait for one callback, for at most `timeout_sec`, and run it."""
        self._spin_once(timeout_sec, never)

    def spin_once_until_future_complete(self, future: Future, timeout_sec: float | TimeoutObject | None = None) -> None:
        """Like `spin_once`, but also return when `future` is done."""
        future.add_done_callback(lambda _: self.wake())
        self._spin_once(timeout_sec, future.done)


class MultiThreadedExecutor(Executor):
    """Runs callbacks in a pool of threads, as far as their callback groups allow.

    The default of `num_threads` is the number of processors that this program may use. The next spin raises a callback's
    exception. `shutdown` does not wait for running callbacks; the end of a program does.

    >>> import threading
    >>> both = threading.Barrier(2)  # two threads must meet here
    >>> together = rclpy.callback_groups.ReentrantCallbackGroup()
    >>> def meet():
    ...     both.wait()
    ...     done.set_result("both callbacks ran at the same time") if not done.done() else None
    >>> done = rclpy.task.Future()
    >>> timers = [node.create_timer(1.0, meet, together), node.create_timer(1.0, meet, together)]
    >>> executor = rclpy.executors.MultiThreadedExecutor(num_threads=2)
    >>> executor.add_node(node)
    True
    >>> executor.spin_until_future_complete(done)
    >>> done.result()
    'both callbacks ran at the same time'
    >>> executor.shutdown()
    True
    """

    def __init__(self, num_threads: int | None = None, *, context: Context | None = None) -> None:
        self._free = current().clock.new_event()
        super().__init__(context=context)
        if num_threads is None:
            num_threads = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 2
        if num_threads == 1:
            warnings.warn(_ONE_THREAD, stacklevel=1)
        if num_threads <= 0:
            raise ValueError("max_workers must be greater than 0")
        self._pool = ThreadPool(num_threads, self._clock, self.wake)

    def wake(self) -> None:
        """Make a blocked spin check for work again, even if it waits for a thread."""
        super().wake()
        self._free.set()

    def __del__(self) -> None:
        if "_pool" in self.__dict__:
            self._pool.close()

    def shutdown(self, timeout_sec: float | None = None) -> bool:
        """Stop and return True. Threads that run a callback end after it."""
        stopped = super().shutdown(timeout_sec)
        self._pool.close()
        return stopped

    def _spin_once(self, timeout_sec: float | TimeoutObject | None, condition: Callable[[], bool]) -> None:
        self._raise_error()
        deadline = deadline_of(timeout_sec)
        try:
            if self._pool.is_full():
                self._wait_for_thread(deadline, condition)
            entity, work = self._next_work(timeout_sec, condition)
        except (ShutdownException, TimeoutException, ConditionReachedException):
            self._raise_error()
            return
        self._pool.submit(lambda: self._work(entity, work))

    def _wait_for_thread(self, deadline: int | None, condition: Callable[[], bool]) -> None:
        """Wait until a thread is free. Everything else that ends a spin also ends this wait."""
        while True:
            self._free.clear()
            if not self._pool.is_full():
                return
            if self._is_shutdown:
                raise ShutdownException()
            if not self._context.ok():
                raise ExternalShutdownException()
            if self._errors or condition():
                raise ConditionReachedException()
            left = None if deadline is None else (deadline - self._clock.steady()) * 1e-9
            if left is not None and left <= 0:
                self._clock.poll(_POLL_WEIGHT)
                raise TimeoutException()
            self._free.wait(left)

    def _work(self, entity: Any, work: Any) -> None:
        try:
            self._run(entity, work)
        except ProcessKilled:
            raise
        except (Exception, CallbackAbandoned) as error:
            self._errors.append(error)
        except BaseException:  # such as SystemExit: it ends the callback, but neither its thread nor the program
            pass

    def _raise_error(self) -> None:
        if self._errors:
            raise self._errors.pop(0)

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Wait for one callback and run it in a thread of the pool."""
        self._spin_once(timeout_sec, never)

    def spin_once_until_future_complete(self, future: Future, timeout_sec: float | TimeoutObject | None = None) -> None:
        """Like `spin_once`, but also return when `future` is done."""
        future.add_done_callback(lambda _: self.wake())
        self._spin_once(timeout_sec, future.done)
