"""rclpy's handling of Ctrl-C and `kill` in each process."""

from __future__ import annotations

import signal
import threading
from typing import TYPE_CHECKING, Any

from coursekit.processes.patching import IMPORTS, Change, patch_manager
from coursekit.processes.process import current_process
from coursekit.processes.session import current
from coursekit.processes.signal_waker import SignalWaker
from coursekit.systems import operating_system
from rclpy._rclpy_pybind11 import GuardCondition, SignalHandlerOptions
from rclpy.context import shutdown_all

if TYPE_CHECKING:
    from rclpy.context import Context

__all__ = [
    "SignalHandlerGuardCondition",
    "SignalHandlerOptions",
    "get_current_signal_handlers_options",
    "install_signal_handlers",
    "uninstall_signal_handlers",
]

_interpreter: dict[str, Any] = {"options": SignalHandlerOptions.NO, "previous": {}, "waker": None}


class SignalHandlerGuardCondition:
    """A guard condition that a signal triggers."""

    def __init__(self, context: Context | None = None) -> None:
        self.handle = GuardCondition()

    def destroy(self) -> None:
        """Destroy the guard condition."""
        self.handle.destroy_when_not_in_use()


def install_signal_handlers(options: SignalHandlerOptions = SignalHandlerOptions.ALL) -> None:
    """Handle SIGINT (shut contexts down, then KeyboardInterrupt) and SIGTERM (shut contexts down)."""
    process = current_process()
    if process is not None:
        process.locals["signal_options"] = options
        if _react not in process.on_signal:
            process.on_signal.append(_react)
        return
    _install_in_interpreter(options)


def _react(signum: int) -> bool:
    """Handle a signal in a process: shut its contexts down. True if no further handling is needed, as for SIGTERM."""
    process = current_process()
    options = process.locals.get("signal_options", 0) if process is not None else 0
    if signum == signal.SIGINT and options & SignalHandlerOptions.SIGINT:
        shutdown_all()
    elif signum == signal.SIGTERM and options & SignalHandlerOptions.SIGTERM:
        shutdown_all()
        return True
    return False


def _install_in_interpreter(options: SignalHandlerOptions) -> None:
    """Install the interpreter's handlers. A kernel's belong to Jupyter, and only the main thread may install any."""
    if current().embedded or threading.current_thread() is not threading.main_thread():
        return
    for signum, bit in ((signal.SIGINT, 1), (signal.SIGTERM, 2)):
        if options & bit and signum not in _interpreter["previous"]:
            _interpreter["previous"][signum] = signal.signal(signum, _handle)
    if _interpreter["waker"] is None and not operating_system.WINDOWS and not current().clock.virtual:
        _interpreter["waker"] = SignalWaker()
    _interpreter["options"] = options
    patch_manager.lend(_HANDLERS)


def _handle(signum: int, frame: Any) -> None:
    clock = current().clock
    if clock.virtual and clock.running is not clock.main:
        clock.main.post(lambda: _end_and_pass_on(signum, frame))
    else:
        _end_and_pass_on(signum, frame)


def _end_and_pass_on(signum: int, frame: Any) -> None:
    previous = _interpreter["previous"].get(signum)
    shutdown_all()
    if callable(previous):
        previous(signum, frame)


def uninstall_signal_handlers() -> None:
    """Remove the signal handlers."""
    process = current_process()
    if process is not None:
        process.locals["signal_options"] = SignalHandlerOptions.NO
        return
    _uninstall_in_interpreter()


def _uninstall_in_interpreter() -> None:
    if threading.current_thread() is not threading.main_thread():
        return
    for signum, previous in _interpreter["previous"].items():
        if signal.getsignal(signum) is _handle:
            signal.signal(signum, previous)
    if _interpreter["waker"] is not None:
        _interpreter["waker"].close()
    _interpreter.update(previous={}, options=SignalHandlerOptions.NO, waker=None)


_HANDLERS = Change(
    "handlers of SIGINT and SIGTERM",
    lambda _nothing: _uninstall_in_interpreter,
    "Ctrl-C and kill end the contexts of rclpy, between init() and shutdown()",
    "tests/processes/test_patches.py",
    IMPORTS,
)


def patches() -> list[Change]:
    """The changes that `rclpy.init` makes in a plain interpreter."""
    return [_HANDLERS]


def get_current_signal_handlers_options() -> SignalHandlerOptions:
    """The signals that are handled now."""
    process = current_process()
    options = _interpreter["options"] if process is None else process.locals.get("signal_options", 0)
    return SignalHandlerOptions(options)
