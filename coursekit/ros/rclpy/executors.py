"""Executors: they wait for ready entities and run their callbacks."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any

from coursekit.core.session import current
from rclpy._executor_base import Executor
from rclpy._executor_work import (
    ConditionReachedException,
    ExternalShutdownException,
    ShutdownException,
    TimeoutException,
    TimeoutObject,
    await_or_execute,
    never,
)
from rclpy._lent import lender
from rclpy.task import Future

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


class SingleThreadedExecutor(Executor):
    """Runs callbacks one after the other in the thread that spins."""

    def __init__(self, *, context: Any = None) -> None:
        super().__init__(context=context)

    def _spin_once(self, timeout_sec: Any, condition: Callable[[], bool]) -> None:
        try:
            entity, work = self._next_work(timeout_sec, condition)
        except (ShutdownException, TimeoutException, ConditionReachedException):
            return
        self._run(entity, work)

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Wait for one callback and run it, at most `timeout_sec`."""
        self._spin_once(timeout_sec, never)

    def spin_once_until_future_complete(self, future: Future, timeout_sec: Any = None) -> None:
        """Like `spin_once`, and returns when `future` is done."""
        future.add_done_callback(lambda _: self.wake())
        self._spin_once(timeout_sec, future.done)


class MultiThreadedExecutor(Executor):
    """Runs callbacks in several threads, as far as their callback groups allow."""

    def __init__(self, num_threads: int | None = None, *, context: Any = None) -> None:
        super().__init__(context=context)
        if num_threads is None:
            num_threads = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
        self._num_threads = max(1, num_threads or 2)
        self._working = 0
        self._free = self._clock.new_event()

    def _spin_once(self, timeout_sec: Any, condition: Callable[[], bool]) -> None:
        self._raise_error()
        try:
            entity, work = self._next_work(timeout_sec, condition)
        except (ShutdownException, TimeoutException, ConditionReachedException):
            self._raise_error()
            return
        while self._working >= self._num_threads:
            self._free.clear()
            if self._working >= self._num_threads:
                self._free.wait()
        with self._lock:
            self._working += 1
        current().spawn(self._work, entity, work)

    def _work(self, entity: Any, work: Any) -> None:
        try:
            self._run(entity, work)
        except Exception as error:
            self._errors.append(error)
        finally:
            with self._lock:
                self._working -= 1
            self._free.set()
            self.wake()

    def _raise_error(self) -> None:
        if self._errors:
            raise self._errors.pop(0)

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Wait for one callback and have a thread run it."""
        self._spin_once(timeout_sec, never)

    def spin_once_until_future_complete(self, future: Future, timeout_sec: Any = None) -> None:
        """Like `spin_once`, and returns when `future` is done."""
        future.add_done_callback(lambda _: self.wake())
        self._spin_once(timeout_sec, future.done)
