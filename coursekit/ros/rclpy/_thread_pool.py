"""The threads of a multi-threaded executor: started on demand, reused, and limited in number."""

from __future__ import annotations

import itertools
import threading
import weakref
from collections import deque
from collections.abc import Callable
from typing import Any

from coursekit.processes.process import current_process
from coursekit.processes.session import locals_here

_KEY = "rclpy.thread_pools"


class ThreadPool:
    """Runs jobs in at most `size` threads; a thread that has finished its job takes the next.

    A thread waits for work on the session's clock: a Ctrl-C or the end of its process interrupts the wait, and on the
    virtual clock the order is the same in every run. `concurrent.futures` would wait in C code, uninterruptibly.

    >>> from coursekit.core.clock import WallClock
    >>> clock = WallClock(); pool = ThreadPool(2, clock); done = clock.new_event()
    >>> pool.submit(done.set); done.wait(5.0)
    True
    """

    def __init__(self, size: int, clock: Any, on_free: Callable[[], None] | None = None) -> None:
        self.size = size
        self._clock = clock
        self._on_free = None if on_free is None else weakref.WeakMethod(on_free)  # threads must not keep an executor alive
        self._lock = threading.Lock()
        self._name = f"ThreadPoolExecutor-{next(locals_here().setdefault(_KEY, itertools.count()))}"
        self._started = 0
        self._idle: deque[_Worker] = deque()
        self._closed = False
        process = current_process()
        if process is not None:
            process.before_join.append(self.close)

    def is_full(self) -> bool:
        """Whether all `size` threads are busy."""
        return self._started >= self.size and not self._idle

    def submit(self, job: Callable[[], Any]) -> None:
        """Run `job` in a thread. `job` must not raise, and the caller must have checked that the pool is not full."""
        with self._lock:
            worker = self._idle.popleft() if self._idle else None
            if worker is None:
                worker = _Worker(self, self._clock, f"{self._name}_{self._started}")
                self._started += 1
        worker.give(job)

    def close(self) -> None:
        """End the idle threads now, and the busy ones after their jobs."""
        with self._lock:
            self._closed = True
            idle = list(self._idle)
            self._idle.clear()
        for worker in idle:
            worker.give(None)

    def rest(self, worker: _Worker) -> bool:
        """Note that a thread is idle; False if it must end."""
        with self._lock:
            goes_on = not self._closed
            if goes_on:
                self._idle.append(worker)
        on_free = self._on_free() if self._on_free is not None else None
        if on_free is not None:
            on_free()
        return goes_on


class _Worker:
    """One thread of a pool."""

    def __init__(self, pool: ThreadPool, clock: Any, name: str) -> None:
        self._pool = pool
        self._waiter = clock.new_waiter()
        self._jobs: deque[Callable[[], Any] | None] = deque()
        in_process = current_process() is not None  # a process waits for non-daemon threads, as Python does
        self._thread: threading.Thread | None = threading.Thread(target=self._work, name=name, daemon=not in_process)

    def give(self, job: Callable[[], Any] | None) -> None:
        """Run `job` in this thread; None ends the thread."""
        self._jobs.append(job)
        thread, self._thread = self._thread, None
        if thread is not None:
            thread.start()
        else:
            self._waiter.notify()

    def _work(self) -> None:
        while (job := self._next()) is not None:
            job()
            del job  # it refers to the executor, which a waiting thread would keep alive
            if not self._pool.rest(self):
                return

    def _next(self) -> Callable[[], Any] | None:
        while not self._jobs:
            self._waiter.wait()
        return self._jobs.popleft()
