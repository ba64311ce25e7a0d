"""Threads that belong to their process, and that the virtual clock can run one at a time.

A thread started by a process inherits the process's context (output, argv, Ctrl-C). On the virtual clock it becomes a
greenlet; while it waits, the others run (locks.py).
"""

from __future__ import annotations

import contextvars
import sys
import threading
import traceback
from collections.abc import Callable
from concurrent.futures import thread as pools

from coursekit.core.execution_context import ProcessKilled

from .current_session import starting_session, virtual_session_here
from .process import Process, current_process

_start = threading.Thread.start
_join = threading.Thread.join
_is_alive = threading.Thread.is_alive
_current_thread = threading.current_thread

SWITCH_INTERVAL = 0.0005
"""Thread switch interval [s]: with Python's 5 ms a busy cell slows down every switch between threads."""


def _run_of(thread: threading.Thread, process: Process | None) -> Callable[[], None]:
    """Return the thread's function: its own `run`, in a copy of the current context."""
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
    session = starting_session()
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
    """Let a pool finish its work and end after main, as Python does at exit: the session's interpreter continues to run."""
    if getattr(thread, "_target", None) is not pools._worker:  # type: ignore[attr-defined]
        return
    reference = thread._args[0]  # type: ignore[attr-defined]

    def end() -> None:
        if (pool := reference()) is not None:
            pool.shutdown(wait=False)

    process.before_join.append(end)


class _EndedHandle:
    """The handle with which a thread of Python 3.13 or newer checks whether it has ended."""

    ident = 0

    def is_done(self) -> bool:
        return True

    def join(self, timeout: float | None = None) -> None:
        pass


def _tell_python_of_end(thread: threading.Thread) -> None:
    """Mark a greenlet as ended for Python's own `is_alive` and `join`: ours are removed with the session."""
    for name in ("_os_thread_handle", "_handle"):  # Python 3.14's, and 3.13's
        if hasattr(thread, name):
            setattr(thread, name, _EndedHandle())
            return
    thread._is_stopped = True  # type: ignore[attr-defined]


def join(self: threading.Thread, timeout: float | None = None) -> None:
    """`Thread.join`; in a process Ctrl-C ends it."""
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
    """`Thread.is_alive`, also for threads that are greenlets."""
    ended = getattr(self, "_coursekit_ended", None)
    return not ended.is_set() if ended is not None else _is_alive(self)


def current_thread() -> threading.Thread:
    """`threading.current_thread`, extended to the virtual clock's execution contexts."""
    session = virtual_session_here()
    context = session.clock.running if session is not None else None
    return getattr(context, "thread", None) or _current_thread()


def switch_often(_nothing: object = None) -> Callable[[], None]:
    """Switch between threads more often; return the function that undoes it."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(min(before, SWITCH_INTERVAL))
    return lambda: sys.setswitchinterval(before)
