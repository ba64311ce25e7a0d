"""Locks and conditions of the virtual clock: waiting for one lets the other greenlets run, instead of blocking their
only thread. Event, Queue and Future are built on them.
"""

from __future__ import annotations

import queue
import threading
from typing import Any

from coursekit.core.clock import waited_ns

from .current_process import current_process
from .current_session import virtual_session_here, waiting_session

_condition_wait = threading.Condition.wait
_RealLock = threading.Lock
PythonQueue = queue._PySimpleQueue  # type: ignore[attr-defined]
"""Python's pure implementation of `queue.SimpleQueue`: it waits with the locks below."""


class _Released:
    """The lock that `Condition.notify` releases for a waiting execution context."""

    def __init__(self, clock: Any) -> None:
        self._waiter = clock.new_waiter()
        self.wait = self._waiter.wait

    def release(self) -> None:
        self._waiter.notify()


def condition_wait(self: threading.Condition, timeout: float | None = None) -> bool:
    """`Condition.wait`, on the session's clock if the caller is an execution context or a process."""
    process, session = current_process(), waiting_session()
    session = session or (process.session if process is not None else None)
    if session is None:
        return _condition_wait(self, timeout)
    if not self._is_owned():  # type: ignore[attr-defined]
        raise RuntimeError("cannot wait on un-acquired lock")
    clock = session.clock
    waiter = _Released(clock)
    self._waiters.append(waiter)  # type: ignore[attr-defined]
    saved = self._release_save()  # type: ignore[attr-defined]
    notified = False
    try:
        notified = waiter.wait(None if timeout is None else clock.steady() + waited_ns(timeout))
        return notified
    finally:
        self._acquire_restore(saved)  # type: ignore[attr-defined]
        if not notified and waiter in self._waiters:  # type: ignore[attr-defined]
            self._waiters.remove(waiter)  # type: ignore[attr-defined]


class VirtualLock:
    """`threading.Lock` for greenlets: waiting for it lets the others run."""

    def __init__(self) -> None:
        self._lock = _RealLock()
        self._waiters: list[Any] = []

    def acquire(self, blocking: bool = True, timeout: float = -1) -> bool:
        if self._lock.acquire(False):
            return True
        session = waiting_session()
        if session is None:
            return self._lock.acquire(blocking, timeout)
        deadline = None if timeout < 0 else session.clock.steady() + waited_ns(timeout)
        while not self._lock.acquire(False):
            if not blocking or (deadline is not None and session.clock.steady() >= deadline):
                return False
            waiter = session.clock.new_waiter()
            self._waiters.append(waiter)
            try:
                if self._lock.acquire(False):  # released by a real thread that saw no waiter
                    return True
                waiter.wait(deadline)
            finally:
                self._waiters.remove(waiter)
        return True

    def release(self) -> None:
        self._lock.release()
        if self._waiters:
            self._waiters[0].notify()

    def locked(self) -> bool:
        return self._lock.locked()

    def _at_fork_reinit(self) -> None:
        self._lock = _RealLock()
        self._waiters = []

    def __enter__(self) -> bool:
        return self.acquire()

    def __exit__(self, *_error: object) -> None:
        self.release()


class VirtualRLock:
    """`threading.RLock` for greenlets: owned by one of them, not by their common thread."""

    def __init__(self) -> None:
        self._block = VirtualLock()
        self._owner: Any = None
        self._count = 0

    @staticmethod
    def _me() -> Any:
        session = virtual_session_here()
        return threading.get_ident() if session is None else session.clock.running

    def acquire(self, blocking: bool = True, timeout: float = -1) -> bool:
        me = self._me()
        if self._owner == me:
            self._count += 1
            return True
        if not self._block.acquire(blocking, timeout):
            return False
        self._owner, self._count = me, 1
        return True

    def release(self) -> None:
        if self._owner != self._me():
            raise RuntimeError("cannot release un-acquired lock")
        self._count -= 1
        if not self._count:
            self._owner = None
            self._block.release()

    def locked(self) -> bool:
        return self._block.locked()  # Python 3.14 calls it

    def _at_fork_reinit(self) -> None:
        self._block._at_fork_reinit()
        self._owner, self._count = None, 0

    def _is_owned(self) -> bool:
        return bool(self._owner == self._me())

    def _release_save(self) -> tuple[int, Any]:
        saved = self._count, self._owner
        self._count, self._owner = 0, None
        self._block.release()
        return saved

    def _acquire_restore(self, saved: tuple[int, Any]) -> None:
        self._block.acquire()
        self._count, self._owner = saved

    def __enter__(self) -> bool:
        return self.acquire()

    def __exit__(self, *_error: object) -> None:
        self.release()
