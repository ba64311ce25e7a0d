"""Threads that belong to their process, and that the virtual clock can run one at a time.

A thread started by a process inherits what is the process's (output, argv, Ctrl-C). On the virtual clock it becomes a
greenlet. There, whatever waits in the `threading` module (Condition, and with it Event, Queue and Future; Lock; join) lets
the others run instead of blocking the only thread there is.
"""

from __future__ import annotations

import contextvars
import queue
import sys
import threading
import time
import traceback
from collections.abc import Callable
from concurrent.futures import thread as pools
from typing import Any

from coursekit.core.clock import waited_ns
from coursekit.core.execution_context import ProcessKilled

from .current_session import virtual_session_here
from .process import Process, current_process

_start = threading.Thread.start
_join = threading.Thread.join
_is_alive = threading.Thread.is_alive
_condition_wait = threading.Condition.wait
_current_thread = threading.current_thread
_RealLock = threading.Lock
CLOCKS = ("time", "monotonic", "perf_counter", "time_ns", "monotonic_ns", "perf_counter_ns")
_real_clocks = {name: getattr(time, name) for name in CLOCKS}


SWITCH_INTERVAL = 0.0005
"""Seconds a thread keeps the interpreter: with Python's 5 ms a busy cell makes every hand-off between threads slow."""
_OF_THE_KERNEL = ("IPython", "anywidget", "asyncio", "comm", "ipykernel", "ipywidgets", "tornado", "traitlets", "zmq")
_COMPILER = "numba"
"""It reads the time to measure itself, thousands of times for each function: no loop that waits."""
_OF_PYTHON = ("concurrent", "coursekit", "queue", "threading")


def _waiting_session() -> Any:
    """The virtual session on whose clock the caller waits; None for a kernel's own libraries, which wait for real."""
    session = virtual_session_here()
    if session is None or not session.embedded or current_process() is not None:
        return session
    return None if _caller() in _OF_THE_KERNEL else session


def _starting_session() -> Any:
    """The virtual session on whose clock a thread runs; None for one in which IPython waits for a program of the system."""
    session = virtual_session_here()
    if session is None or not session.embedded or current_process() is not None:
        return session
    return None if _caller() == "IPython" else session


def _caller() -> str:
    """The library that called, past those of Python and our own."""
    frame: Any = sys._getframe(2)
    while frame is not None:
        top = str(frame.f_globals.get("__name__", "")).partition(".")[0]
        if top not in _OF_PYTHON:
            return top
        frame = frame.f_back
    return ""


def _run_of(thread: threading.Thread, process: Process | None) -> Callable[[], None]:
    """What the thread runs: its own `run`, in a copy of the present context."""
    run = thread.run
    context = contextvars.copy_context()

    def body() -> None:
        if process is not None:
            process.contexts.append(process.session.execution_context())
        try:
            run()
        except (ProcessKilled, SystemExit):
            pass
        except BaseException:
            if process is None or process.exit_code is None:
                print(f"Exception in thread {thread.name}:\n{traceback.format_exc()}", end="", file=sys.stderr)

    return lambda: context.run(body)


def start(self: threading.Thread) -> None:
    """`Thread.start`, for processes and the virtual clock."""
    process = current_process()
    session = _starting_session()
    if process is None and session is None:
        _start(self)
        return
    if process is not None and not self.daemon:
        process.threads.append(self)
        _end_pool_with(process, self)
    run = _run_of(self, process)
    if session is None:
        self.run = run  # type: ignore[method-assign]
        self._daemonic = True  # type: ignore[attr-defined] # its process waits for it, not the interpreter
        _start(self)
        return
    ended = session.clock.new_event()
    self._coursekit_ended = ended  # type: ignore[attr-defined]
    self._started.set()  # type: ignore[attr-defined]

    def lane_main() -> None:
        session.clock.running.thread = self
        try:
            run()
        finally:
            _tell_python_of_end(self)
            ended.set()

    session.clock.spawn(lane_main, self.name)


def _end_pool_with(process: Process, thread: threading.Thread) -> None:
    """Let a pool do what it was given and end when main has, as Python does at its exit: a session's Python goes on."""
    if getattr(thread, "_target", None) is not pools._worker:  # type: ignore[attr-defined]
        return
    reference = thread._args[0]  # type: ignore[attr-defined]

    def end() -> None:
        if (pool := reference()) is not None:
            pool.shutdown(wait=False)

    process.before_join.append(end)


class _EndedHandle:
    """What a thread has from Python 3.13 on to ask the system whether it has ended."""

    ident = 0

    def is_done(self) -> bool:
        return True

    def join(self, timeout: float | None = None) -> None:
        pass


def _tell_python_of_end(thread: threading.Thread) -> None:
    """Let Python's own `is_alive` and `join` know that a greenlet has ended: ours are taken back with the session."""
    for name in ("_os_thread_handle", "_handle"):  # Python 3.14's, and 3.13's
        if hasattr(thread, name):
            setattr(thread, name, _EndedHandle())
            return
    thread._is_stopped = True  # type: ignore[attr-defined]


def join(self: threading.Thread, timeout: float | None = None) -> None:
    """`Thread.join`; in a process a Ctrl-C ends it."""
    ended = getattr(self, "_coursekit_ended", None)
    if ended is not None:
        ended.wait(timeout)
    elif current_process() is None or timeout is not None:
        _join(self, timeout)
    else:
        clock = current_process().session.clock  # type: ignore[union-attr]
        while _is_alive(self):
            _join(self, 0.05)
            clock.sleep(0)


def is_alive(self: threading.Thread) -> bool:
    """`Thread.is_alive`."""
    ended = getattr(self, "_coursekit_ended", None)
    return not ended.is_set() if ended is not None else _is_alive(self)


def current_thread() -> threading.Thread:
    """`threading.current_thread`, which knows the virtual clock's execution contexts."""
    session = virtual_session_here()
    context = session.clock.running if session is not None else None
    return getattr(context, "thread", None) or _current_thread()


class _Released:
    """What `Condition.notify` releases for an execution context that waits."""

    def __init__(self, clock: Any) -> None:
        self._waiter = clock.new_waiter()
        self.wait = self._waiter.wait

    def release(self) -> None:
        self._waiter.notify()


def condition_wait(self: threading.Condition, timeout: float | None = None) -> bool:
    """`Condition.wait`, on the session's clock where the caller is an execution context or a process."""
    process, session = current_process(), _waiting_session()
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
    """`threading.Lock` for greenlets: one that has to wait lets the others run."""

    def __init__(self) -> None:
        self._lock = _RealLock()
        self._waiters: list[Any] = []

    def acquire(self, blocking: bool = True, timeout: float = -1) -> bool:
        if self._lock.acquire(False):
            return True
        session = _waiting_session()
        if session is None:
            return self._lock.acquire(blocking, timeout)
        deadline = None if timeout < 0 else session.clock.steady() + waited_ns(timeout)
        while not self._lock.acquire(False):
            if not blocking or (deadline is not None and session.clock.steady() >= deadline):
                return False
            waiter = session.clock.new_waiter()
            self._waiters.append(waiter)
            try:
                if self._lock.acquire(False):  # opened by a real thread that saw nobody wait
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
    """`threading.RLock` for greenlets: owned by one of them, not by the thread that they share."""

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
        return self._block.locked()  # Python 3.14 asks it

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


def switch_often(_nothing: object = None) -> Callable[[], None]:
    """Let threads take turns more often; returns what undoes it."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(min(before, SWITCH_INTERVAL))
    return lambda: sys.setswitchinterval(before)


def _reader(name: str) -> Callable[[], Any]:
    real = _real_clocks[name]
    in_seconds = not name.endswith("_ns")
    is_system_time = name.startswith("time")

    def read() -> Any:
        process = current_process()
        if process is None or not process.session.clock.virtual:
            return real()
        clock = process.session.clock
        if sys._getframe(1).f_globals.get("__name__", "").partition(".")[0] != _COMPILER:
            clock.poll()
        nanoseconds = clock.now() if is_system_time else clock.steady()
        return nanoseconds / 1_000_000_000 if in_seconds else nanoseconds

    return read


_readers = {name: _reader(name) for name in CLOCKS}
monotonic = _readers["monotonic"]
PythonQueue = queue._PySimpleQueue  # type: ignore[attr-defined]


def clock_reader(name: str) -> Callable[[Any], Any]:
    """What gives `time.NAME` of the session's clock."""
    return lambda _real: _readers[name]
