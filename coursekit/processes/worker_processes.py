"""multiprocessing in a program: workers know its own functions, and other programs run while it waits for a worker.

Only programs that run in a session's own interpreter need this; others have their own (`coursekit.processes.script`).
"""

from __future__ import annotations

import _signal  # `signal.signal` is replaced by the session
import functools
import os
import selectors
import sys
from collections.abc import Callable
from multiprocessing import connection
from typing import Any

from coursekit.core.clock import waited_ns
from coursekit.core.virtual_clock import is_virtual_thread

from .current_process import current_process, owner
from .patching import PRIVATE, VIRTUAL, Patch, always, patch_manager
from .pickling import with_own_modules
from .private_modules import private_of_process

STEP = 0.005
"""Polling interval for a worker, virtual and real [s]."""
_real_wait = connection.wait


def _virtual_clock() -> Any:
    """Return the virtual clock whose execution contexts the calling program would block; None on the wall clock."""
    process = current_process()
    clock = None if process is None else process.session.clock
    return clock if clock is not None and is_virtual_thread(clock) else None


def _ready(objects: list[Any], seconds: float) -> bool:
    """Return whether one of them is ready within so much real time; `wait` reads the clock, which would not advance then."""
    if sys.platform == "win32":
        return bool(_real_wait(objects, seconds))
    with selectors.PollSelector() as selector:
        for thing in objects:
            selector.register(thing, selectors.EVENT_READ)
        return bool(selector.select(seconds))


def _wait(clock: Any, happens: Callable[[], bool], timeout: float | None) -> bool:
    """Let the others run until it happens, or for so many virtual seconds; `happens` blocks for up to STEP real seconds."""
    end = None if timeout is None else clock.steady() + waited_ns(timeout)
    while not happens():
        if end is not None and clock.steady() >= end:
            return False
        clock.sleep(STEP)
    return True


def _let_others_run(objects: list[Any], timeout: float | None = None) -> None:
    """On the virtual clock, wait until one of them is ready, or for so many virtual seconds."""
    clock = _virtual_clock()
    if clock is not None:
        _wait(clock, lambda: _ready(objects, STEP), timeout)


def _waits_first(real: Callable[..., Any]) -> Callable[..., Any]:
    """Wrap `Connection._recv`: on the virtual clock it only reads available data."""

    @functools.wraps(real)
    def receive(self: Any, size: int, *args: Any, **kwargs: Any) -> Any:
        if size:
            _let_others_run([self])
        return real(self, size, *args, **kwargs)

    return receive


def _looks_first(real: Callable[..., Any]) -> Callable[..., Any]:
    """Wrap `multiprocessing.connection.wait`."""

    @functools.wraps(real)
    def wait(object_list: Any, timeout: float | None = None) -> Any:
        objects = list(object_list)
        _let_others_run(objects, timeout)
        return real(objects, timeout if _virtual_clock() is None else -1)  # not 0: that would wait for a stopped clock

    return wait


def _asks_first(real: Callable[..., Any]) -> Callable[..., Any]:
    """Wrap `Popen.wait`, which waits for the end of a worker."""

    @functools.wraps(real)
    def wait(self: Any, timeout: float | None = None) -> Any:
        _let_others_run([self.sentinel], timeout)
        return real(self, timeout)

    return wait


def _acquire(lock: Any, block: bool = True, timeout: float | None = None) -> bool:
    """`acquire` of multiprocessing's locks: a worker that holds one may be waiting for another thread of this program."""
    clock = _virtual_clock()
    if clock is None or not block:
        return bool(lock._semlock.acquire(block, timeout))
    return _wait(clock, lambda: bool(lock._semlock.acquire(True, STEP)), timeout)


def _with_acquire(real: Callable[..., Any]) -> Callable[..., Any]:
    """Wrap `SemLock._make_methods`, which defines a lock's methods."""

    @functools.wraps(real)
    def make_methods(self: Any) -> None:
        real(self)
        self.acquire = functools.partial(_acquire, self)

    return make_methods


def _be_a_worker() -> None:
    """Restore Python in a forked interpreter, right after the fork: nothing drives the virtual clock there.

    A pool ends its workers with SIGTERM, for which the interpreter may have a handler.
    """
    if current_process() is not None:
        _signal.signal(_signal.SIGTERM, _signal.SIG_DFL)
    clock = _virtual_clock()
    if clock is not None:
        private = private_of_process()
        clock.thread = 0  # locks created before the fork must not yield in this thread
        patch_manager.leave_all()
        owner.set(None)
        if private is not None:
            sys.modules.update(private.modules)
            sys.modules["__main__"] = private.main or sys.modules["__main__"]


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_be_a_worker)


def patches() -> list[Patch]:
    """Return the replacements in multiprocessing."""
    return _PATCHES


def install() -> None:
    """Add the patches of multiprocessing, while sessions are open."""
    patch_manager.lend(*_PATCHES)


_OWN, _OTHERS = "a worker is sent a program's own functions", "the others run while a program waits for a worker"
_TEST, _PICKLER = "tests/processes/test_worker_processes.py", "multiprocessing.reduction.ForkingPickler"
_PATCHES = [
    Patch(f"{_PICKLER}.dumps", lambda method: classmethod(with_own_modules(method.__func__)), _OWN, _TEST, PRIVATE),
    Patch(f"{_PICKLER}.loads", lambda method: staticmethod(with_own_modules(method)), _OWN, _TEST, PRIVATE),
    Patch("multiprocessing.connection.Connection._recv", _waits_first, _OTHERS, _TEST, VIRTUAL),
    Patch("multiprocessing.pool.wait", _looks_first, "a copy of `connection.wait` that the pool keeps", _TEST, VIRTUAL),
    Patch("multiprocessing.connection.wait", _looks_first, _OTHERS, _TEST, VIRTUAL),
    Patch("multiprocessing.synchronize.SemLock._make_methods", _with_acquire, _OTHERS, _TEST, VIRTUAL),
    Patch("multiprocessing.synchronize.SemLock.__enter__", always(_acquire), _OTHERS, _TEST, VIRTUAL),
    Patch("multiprocessing.popen_fork.Popen.wait", _asks_first, _OTHERS, _TEST, VIRTUAL),
]
