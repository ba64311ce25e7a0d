"""Delivery of signals to a process: in its own main execution context, as the system would."""

from __future__ import annotations

import ctypes
import signal
from abc import abstractmethod
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from coursekit.core.execution_context import ExecutionContext, ProcessKilled

from .base_process import BaseProcess
from .current_process import owner
from .importing import is_importing
from .output import Input

if TYPE_CHECKING:
    from .process import Process
    from .session import Session


RETRY_NS = 2_000_000
"""Retry interval for a thread that was importing [ns]."""
LONGEST_IMPORT_NS = 120_000_000_000
"""How long a killed program may go on importing [ns]: a module whose import never ends does not keep it for ever."""


class Interruptible(BaseProcess):
    """The part of a process in this interpreter that handles interrupt, terminate and kill."""

    stdin: Input
    _main: Callable[[], Any]
    _main_context: ExecutionContext | None

    def __init__(self, session: Session, name: str, argv: Sequence[str], parent: Process | None) -> None:
        super().__init__(session, name, argv, parent)
        self.handlers: dict[int, Any] = {}
        self.on_signal: list[Callable[[int], bool]] = []
        """Called in the main execution context when a signal arrives; True means that it is handled."""

    def send_signal(self, signum: int) -> None:
        """Deliver a signal as the system would, in the process's own main execution context."""
        if self.exit_code is not None:
            return
        if signum == 9:
            self._kill()
        else:
            self._deliver(lambda: self._receive(signum))

    def _receive(self, signum: int) -> None:
        if signum == signal.SIGINT and self.stdin.take_ctrl_c():
            return
        handler = self.handlers.get(signum, signal.SIG_DFL)
        reactions = [react(signum) for react in list(self.on_signal)] if handler == signal.SIG_DFL else []
        if any(reactions):
            return
        if callable(handler) and handler is not signal.default_int_handler:
            handler(int(signum), None)
        elif handler == signal.SIG_IGN:
            return
        elif signum == signal.SIGINT:
            raise KeyboardInterrupt
        else:
            raise ProcessKilled(signum)

    def _deliver(self, action: Callable[[], None]) -> None:
        context = self._main_context
        if context is None:  # not begun: it is interrupted as soon as it begins
            self._main = action
            return
        context.post(action)
        if not self.session.clock.virtual:
            clock = self.session.clock
            alarm_at = clock.steady() + 50_000_000
            clock.call_at(alarm_at, lambda: self._look_at(context))

    def _look_at(self, context: ExecutionContext) -> None:
        if context.pending:
            self.session.clock.spawn(lambda: self._reach_busy(context), f"signals of {self.name}")

    def _reach_busy(self, context: ExecutionContext) -> None:
        """Call the handler here, as the process, because the context has not waited; an exception is raised in its code."""
        try:
            action = context.pending.popleft()
        except IndexError:
            return
        owner.set(self)  # type: ignore[arg-type] # a handler's output belongs to the program
        try:
            action()
        except BaseException as error:
            self._raise(context, _like(error))

    def _raise(self, context: ExecutionContext, kind: type[BaseException]) -> None:
        if self.exit_code is not None:
            return  # another thread may have its id by now
        if raise_in_thread(context.ident, kind):
            context.wake()  # it may have begun to wait meanwhile, and notices the exception only when it runs
            return
        clock = self.session.clock
        clock.call_at(clock.steady() + RETRY_NS, lambda: self._raise(context, kind))

    def _kill(self) -> None:
        self._deliver(raise_killed)
        if not self.session.clock.virtual:
            alarm_at = self.session.clock.steady() + 1_000_000_000
            self.session.clock.call_at(alarm_at, lambda: self._cut_off(alarm_at + LONGEST_IMPORT_NS))

    def _cut_off(self, latest: int) -> None:
        context, clock = self._main_context, self.session.clock
        if context is not None and clock.steady() < latest and is_importing(context.ident):  # it ends when the import does
            clock.call_at(clock.steady() + RETRY_NS, lambda: self._cut_off(latest))
        elif self.exit_code is None:
            self.abandoned = True
            if self._main_context is not None and not self.session.clock.virtual:
                self.session.cut_off.append(self._main_context.ident)
            self.out.write(
                "stderr",
                f"[coursekit] process {self.name} [{self.pid}] does not answer: it was cut off from the graph, "
                "but its thread is still busy (a call that never returns). Restart the kernel to be rid of it.\n",
            )
            self._end(-9)

    @abstractmethod
    def _end(self, code: int) -> None:
        """Mark it as ended, with this exit code."""


def _like(error: BaseException) -> type[BaseException]:
    """Return a class whose instances, created without arguments, equal the error: Python creates one in the other thread."""
    kind = type(error)

    def again(self: BaseException) -> None:
        kind.__init__(self, *error.args)
        self.__dict__.update(error.__dict__)

    names = {"__module__": kind.__module__, "__qualname__": kind.__qualname__}
    return type(kind.__name__, (kind,), {"__init__": again, **names})


def raise_killed() -> None:
    raise ProcessKilled(9)


def raise_in_thread(ident: int, kind: type[BaseException]) -> bool:
    """Raise `kind` in a thread that runs Python code, at its next bytecode; return False without raising during an import.

    In the import system's own code the exception would leave the import lock acquired, and no thread could ever import
    again; in a module that programs share it would leave half a library for all of them.
    """
    if is_importing(ident):
        return False
    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(ident), ctypes.py_object(kind))
    return True
