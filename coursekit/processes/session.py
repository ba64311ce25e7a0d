"""The session: one clock, its processes, and the graphs (one per ROS domain) that they share.

An interpreter has one current session, created on first use: on the wall clock, or on the virtual one when
COURSEKIT_TIME=virtual. COURSEKIT_STOP_AFTER=SECONDS sends Ctrl-C to everything after that much session time.
"""

from __future__ import annotations

import atexit
import contextlib
import itertools
import os
import signal
import threading
import uuid
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from coursekit.core.clock import Clock, WallClock
from coursekit.core.execution_context import ExecutionContext, ProcessKilled, thread_context
from coursekit.core.graph import Graph
from coursekit.core.virtual_clock import VirtualClock, is_virtual_thread
from coursekit.systems.children import interrupt_self
from coursekit.wiring import MEET, NETWORK, load

from . import current_session
from .patches import patch_manager
from .patching import IMPORTS, PROCESSES, VIRTUAL
from .process import Process, current_process
from .thread_frames import thread_frames

_making = threading.RLock()

NETWORK_VARIABLE = "COURSEKIT_NETWORK"
"""The environment variable with the address of a network to join."""
ALONE = ("COURSEKIT_ALONE", "COURSEKIT_STOP_AFTER")
"""Environment variables that isolate an interpreter's nodes from those of other programs."""


class Session:
    """All programs that run together in one interpreter.

    >>> session = Session(virtual=True)
    >>> with session.use():
    ...     process = session.start(lambda: print("hello"), name="greeter")
    ...     (process.wait(), process.output)
    (0, 'hello\\n')
    """

    def __init__(self, *, virtual: bool = False, environ: Mapping[str, str] | None = None) -> None:
        self.clock: Any = VirtualClock() if virtual else WallClock()
        self.environ: Mapping[str, str] = os.environ if environ is None else environ
        self.processes: list[Process] = []
        self.embedded = False
        """Set if the interpreter is a Jupyter kernel: then only cells and processes run on the virtual clock."""
        self.in_cell = False
        self.meets = False
        """Set if its nodes discover those of other programs on this computer: in a plain interpreter on the wall clock."""
        self.cut_off: list[int] = []
        """Threads of processes that could not be ended."""
        self.graphs: dict[int, Graph] = {}
        self.locals: dict[Any, Any] = {}
        """Data of other packages per session; for the interpreter's own code also the data per process."""
        self.on_start: list[Callable[[Process], None]] = []
        self.on_close: list[Callable[[], object]] = []
        self._pids = itertools.count(1000)
        self._endpoints = itertools.count(1)
        self._uuids = itertools.count(1)
        self._stop_planned = False

    def open(self) -> None:
        """Give each process its own view of interpreter-wide state (streams, signals, time, ...), until `close`."""
        patch_manager.enter(self, IMPORTS, PROCESSES, *([VIRTUAL] if self.clock.virtual else []))

    # -- processes

    def start(
        self,
        main: Callable[[], Any],
        *,
        name: str,
        argv: Sequence[str] = (),
        env: Mapping[str, str] | None = None,
        cwd: str | os.PathLike[str] | None = None,
        on_output: Callable[[str, str], None] | None = None,
        tty: bool = False,
    ) -> Process:
        """Run `main()` in its own process.

        Its sys.argv is `[name, *argv]`; `env` replaces its environment, `cwd` its working folder; `on_output(stream,
        text)` is called with all its output; with `tty` its streams claim to be a terminal. The return value of `main`,
        or the argument of `sys.exit`, is its exit code.
        """
        process = Process(
            self, main, name=name, argv=argv, env=None if env is None else dict(env), cwd=cwd, parent=current_process()
        )
        return self.launch(process, on_output, tty)

    def launch(self, process: Any, on_output: Callable[[str, str], None] | None = None, tty: bool = False) -> Any:
        """Register an existing process and start it."""
        process.tty = tty
        self.open()
        self.plan_stop()
        self.processes.append(process)
        if on_output is not None:
            process.on_output(on_output)
        for listener in list(self.on_start):
            listener(process)
        process.begin()
        return process

    def start_executable(
        self,
        path: str | os.PathLike[str],
        argv: Sequence[str] = (),
        *,
        name: str | None = None,
        env: Mapping[str, str] | None = None,
        cwd: str | os.PathLike[str] | None = None,
        on_output: Callable[[str, str], None] | None = None,
        tty: bool = False,
    ) -> Any:
        """Run an executable of a package: Python ones in this interpreter, others as child processes."""
        from .executables import make_process

        process = make_process(self, Path(path), argv, name=name, env=env, cwd=cwd)
        return self.launch(process, on_output, tty)

    def forget(self, process: Any) -> None:
        """Remove a process that has ended; called by the process."""
        with contextlib.suppress(ValueError):
            self.processes.remove(process)

    def spawn(self, function: Callable[..., Any], *args: Any) -> None:
        """Run `function(*args)` concurrently, inside the caller's process."""
        process = current_process()

        def body() -> None:
            if process is not None:
                process.contexts.append(self.execution_context())
            with contextlib.suppress(ProcessKilled):  # its process has ended
                function(*args)

        self.clock.spawn(body, getattr(function, "__name__", "context"))

    def execution_context(self) -> ExecutionContext:
        """Return the calling execution context."""
        return self.clock.running if is_virtual_thread(self.clock) else thread_context()

    def interrupt_all(self) -> None:
        """Send Ctrl-C to every process; if there is none, to the interpreter's own main execution context."""
        running = [process for process in self.processes if process.parent is None]
        for process in running:
            process.interrupt()
        if not running:
            self._interrupt_main()

    def _interrupt_main(self) -> None:
        if self.clock.virtual:
            self.clock.main.post(lambda: signal.raise_signal(signal.SIGINT))
        else:
            interrupt_self()

    def close(self, grace_sec: float = 2.0) -> None:
        """End every process: with Ctrl-C, then, if it ignores that, with kill."""
        for process in list(self.processes):
            process.interrupt()
        for act in (None, "kill"):
            for process in list(self.processes):
                if act:
                    process.kill()
                process.wait(grace_sec)
        for act_last in list(self.on_close):
            act_last()
        for graph in self.graphs.values():
            graph.clear()
        self.clock.close()
        running = thread_frames()
        if not any(ident in running for ident in self.cut_off):  # otherwise running threads would print as the interpreter
            patch_manager.leave(self)

    # -- shared objects

    def meet(self, domain_id: int) -> None:
        """Let the interpreter's own nodes and those of other programs in the domain discover each other.

        If COURSEKIT_NETWORK names a network, they do so there; with both they would receive everything twice.
        """
        if os.environ.get(NETWORK_VARIABLE) and load(NETWORK)(self, domain_id):
            return
        if self.meets and not self.embedded and current_process() is None:
            load(MEET)(self.graph(domain_id), domain_id)

    def graph(self, domain_id: int = 0) -> Graph:
        """Return the graph of a domain."""
        graph = self.graphs.get(domain_id)
        if graph is None:
            graph = self.graphs.setdefault(domain_id, Graph(self.clock, self._endpoints))
        return graph

    def new_pid(self) -> int:
        """Return a new process id: counted, so it is the same in every run."""
        return next(self._pids)

    def new_uuid(self) -> bytes:
        """Return sixteen unique bytes: random, but counted on the virtual clock."""
        if not self.clock.virtual:
            return uuid.uuid4().bytes
        return uuid.uuid5(uuid.NAMESPACE_OID, f"coursekit {next(self._uuids)}").bytes

    def plan_stop(self) -> None:
        """Schedule the stop for COURSEKIT_STOP_AFTER, once; called when the first node or process appears."""
        seconds = os.environ.get("COURSEKIT_STOP_AFTER")
        if seconds and not self._stop_planned:
            self._stop_planned = True
            self.clock.call_at(self.clock.steady() + round(float(seconds) * 1e9), self.interrupt_all)

    @contextlib.contextmanager
    def use(self) -> Iterator[Session]:
        """Make this the current session inside the block, and close it afterwards."""
        previous, current_session.session = current_session.session, self
        self.open()
        try:
            yield self
        finally:
            self.close()
            current_session.session = previous


def locals_here() -> dict[Any, Any]:
    """Return the data of the calling program: its process's, or the session's for the interpreter's own code."""
    process = current_process()
    return current().locals if process is None else process.locals


def current() -> Session:
    """Return the session of the calling code, created on first use."""
    process = current_process()
    if process is not None:
        return process.session
    if current_session.session is None:
        with _making:
            if current_session.session is None:
                current_session.session = _make()
    return current_session.session


def _make() -> Session:
    kind = os.environ.get("COURSEKIT_TIME") or "wall"
    if kind not in ("wall", "virtual"):
        raise ValueError(f"COURSEKIT_TIME is '{kind}', which is no clock. Set it to 'wall' or 'virtual'.")
    session = Session(virtual=kind == "virtual")
    session.meets = kind == "wall" and not any(os.environ.get(name) for name in ALONE)
    patch_manager.enter(session, IMPORTS)
    if session.clock.virtual:
        session.open()
    atexit.register(_close_at_exit, session)
    return session


def _close_at_exit(session: Session) -> None:
    for process in list(session.processes):
        process.kill()


__all__ = ["Clock", "Session", "current", "locals_here"]
