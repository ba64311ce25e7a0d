"""A process of the session: one unmodified `main()` with its own argv, output, signals and exit code."""

from __future__ import annotations

import contextvars
import ctypes
import functools
import os
import signal
import sys
import threading
import traceback
from collections.abc import Callable, Iterable, Sequence
from types import TracebackType
from typing import TYPE_CHECKING, Any

from coursekit.core.execution_context import ExecutionContext, ProcessKilled, thread_context
from coursekit.interfaces.find import with_underlay
from coursekit.systems.folder import working_folder
from coursekit.systems.letter_case import variable_name

from .current_process import current_process as current_process
from .current_process import owner
from .interrupting import Interruptible, raise_killed
from .output import Input

if TYPE_CHECKING:
    from .session import Session

_ROOM = os.path.dirname(__file__) + os.sep
_PACKAGE = os.path.dirname(os.path.dirname(__file__)) + os.sep
DISTRIBUTION = {
    "ROS_DISTRO": "humble", "ROS_VERSION": "2", "ROS_PYTHON_VERSION": "3", "LD_LIBRARY_PATH": f"{_PACKAGE}lib",
}  # fmt: skip
"""The variables set by sourcing ROS; launch files and nodes read them."""


class Process(Interruptible):
    """One running program of the session.

    Made by `Session.start`; see there.
    """

    def __init__(
        self,
        session: Session,
        main: Callable[[], Any],
        *,
        name: str,
        argv: Sequence[str] = (),
        env: dict[str, str] | None = None,
        cwd: str | os.PathLike[str] | None = None,
        parent: Process | None = None,
    ) -> None:
        super().__init__(session, name, [name, *argv], parent)
        inherited = parent.env if parent is not None else dict(session.environ)
        given = inherited if env is None else env
        self.env: dict[str, str] = {**DISTRIBUTION, **{variable_name(name): value for name, value in given.items()}}
        with_underlay(self.env)
        above = working_folder() if parent is None else parent.cwd
        self.cwd: str = above if cwd is None else os.fspath(cwd)
        self.started = session.clock.steady()
        self.locals: dict[Any, Any] = {}
        """Data of other packages per process: the default rclpy context, log levels, ..."""
        self.cleanups: list[Callable[[], None]] = []
        self.before_join: list[Callable[[], None]] = []
        """Called when its main() has ended, before its threads are joined: pools release their idle threads."""
        self.at_exit: list[functools.partial[Any]] = []
        self.stdin = Input(session)
        self.on_wants_keys: Callable[[], None] | None = None
        """Called when it needs each key at once instead of whole lines; set by the source of its input."""
        self.stdin_to: Any = None
        """A process that receives its input instead, like a shell's foreground program."""
        self.threads: list[threading.Thread] = []
        """Its non-daemon threads: it ends after them."""
        self.contexts: list[ExecutionContext] = []
        self._main = main
        self._main_context: ExecutionContext | None = None

    # -- keyboard input

    def write_stdin(self, text: str) -> None:
        """Write `text` to its standard input."""
        if self.stdin_to is not None:
            self.stdin_to.write_stdin(text)
        else:
            self.stdin.feed(text)

    def want_keys(self) -> None:
        """Request each key at once from the source of the input: a terminal's raw mode."""
        for process in (self, self.parent):
            if process is not None and process.on_wants_keys is not None:
                process.on_wants_keys()

    def close_stdin(self) -> None:
        """Close its standard input, as Ctrl-D does."""
        if self.stdin_to is not None:
            self.stdin_to.close_stdin()
        else:
            self.stdin.end()

    # -- running

    def begin(self) -> None:
        """Start the execution context in which `main` runs."""
        context = contextvars.copy_context()
        context.run(owner.set, self)
        context.run(self.session.clock.spawn, self._run, f"{self.name}-{self.pid}")

    def _run(self) -> None:
        self._main_context = self.session.execution_context()
        if not self.session.clock.virtual:  # threads that it creates are not daemons, like a main thread's
            threading.current_thread()._daemonic = False  # type: ignore[attr-defined]
        code = 1
        try:
            enter_folder(self.cwd)
            code = self._call_main()
            self._call_all(self.before_join)
            self._join_threads()
            self._call_all(reversed(self.at_exit))
        except ProcessKilled as death:
            code = -death.signum
        except BaseException:
            self._report(sys.exc_info())
        finally:
            self._end(code)

    def _call_main(self) -> int:
        try:
            return exit_status(self._main(), self)
        except SystemExit as leaving:
            return exit_status(leaving.code, self)
        except ProcessKilled:
            raise
        except KeyboardInterrupt:
            self._report(sys.exc_info())
            return -int(signal.SIGINT)
        except BaseException:
            self._report(sys.exc_info())
            return 1

    def _join_threads(self) -> None:
        """Wait for the program's non-daemon threads, as Python does."""
        try:
            for thread in list(self.threads):
                thread.join()
        except KeyboardInterrupt:
            self._report(sys.exc_info())

    def _call_all(self, last_words: Iterable[Callable[[], Any]]) -> None:
        for say in last_words:
            try:
                say()
            except Exception:
                self._report(sys.exc_info())

    def _report(self, error: tuple[Any, Any, TracebackType | None]) -> None:
        """Print the traceback from the program's first frame on, without the frames that started it."""
        kind, value, trace = error
        while trace is not None and trace.tb_frame.f_code.co_filename.startswith(_ROOM):
            trace = trace.tb_next
        if kind is KeyboardInterrupt and (trace is None or trace.tb_frame.f_code.co_filename.startswith(_PACKAGE)):
            return  # one of our programs, or one that had not begun: the internals are of no use
        self.out.write("stderr", "".join(traceback.format_exception(kind, value, trace)))

    def _end(self, code: int) -> None:
        if self.exit_code is not None:
            return  # it was detached before
        self._call_all(reversed(self.cleanups))
        self.exit_code = code
        for context in self.contexts:
            if context is not self._main_context:
                context.post(raise_killed)
        self._tell_of_end()
        for kept in (self.before_join, self.cleanups, self.on_signal, self.locals):
            kept.clear()  # type: ignore[attr-defined]
        self._ended.set()


def exit_status(result: Any, process: Process) -> int:
    """Return the exit code of `sys.exit(result)`; a text is printed to stderr and gives 1."""
    if result is None:
        return 0
    if isinstance(result, int):
        return int(result) & 0xFF
    process.out.write("stderr", f"{result}\n")
    return 1


def enter_folder(folder: str) -> None:
    """Give the calling thread its own working folder, where the system supports it (Linux)."""
    if sys.platform != "linux" or thread_context().ident == threading.main_thread().ident:
        return
    clone_fs = 0x200
    if ctypes.CDLL(None, use_errno=True).unshare(clone_fs) == 0 and os.path.isdir(folder):
        os.chdir(folder)
