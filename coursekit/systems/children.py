"""Child processes: started so that this program's Ctrl-C does not reach them, and how to send them signals and text."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
from collections.abc import Mapping
from typing import Any

from . import operating_system

CTRL_BREAK: int = getattr(signal, "CTRL_BREAK_EVENT", 1)
"""The replacement of Ctrl-C on Windows, where Ctrl-C itself reaches nothing or all programs of a console."""
_NEW_GROUP: int = getattr(subprocess, "CREATE_NEW_PROCESS_GROUP", 0x200)


def apart() -> dict[str, Any]:
    """Return the arguments of `subprocess.Popen` that isolate a child from this program's Ctrl-C.

    >>> apart()
    {'start_new_session': True}
    """
    return {"creationflags": _NEW_GROUP} if operating_system.WINDOWS else {"start_new_session": True}


def send_signal(child: subprocess.Popen[Any], signum: int) -> None:
    """Send a signal to a child started with `apart`, and to its descendants; do nothing when it has ended.

    Windows knows two: SIGINT becomes Ctrl-Break, every other one ends the child at once.
    """
    if operating_system.WINDOWS:
        _send_on_windows(child, signum)
    else:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(child.pid, signum)


def _send_on_windows(child: subprocess.Popen[Any], signum: int) -> None:
    if child.poll() is not None:
        return
    try:
        if signum == signal.SIGINT:
            child.send_signal(CTRL_BREAK)
            return
    except (OSError, SystemError):  # os.kill raises SystemError when it fails
        pass  # this program has no console to send it through
    with contextlib.suppress(OSError):
        child.terminate()


def end_family(child: subprocess.Popen[Any]) -> None:
    """End a child started with `apart`, and all its descendants, at once."""
    if operating_system.WINDOWS:
        with contextlib.suppress(OSError):
            subprocess.run(["taskkill", "/F", "/T", "/PID", str(child.pid)], stdin=subprocess.DEVNULL, capture_output=True)
    else:
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(child.pid, signal.SIGKILL)
    with contextlib.suppress(OSError):
        child.kill()


def interrupt_self() -> None:
    """Send Ctrl-C to this program, from any thread; its main thread receives it."""
    if operating_system.WINDOWS:  # os.kill would end the program there
        signal.raise_signal(signal.SIGINT)
    else:
        os.kill(os.getpid(), signal.SIGINT)


def with_utf8(env: Mapping[str, str]) -> dict[str, str]:
    """Return an environment in which a Python child writes UTF-8 to pipes, as it does on Linux.

    >>> with_utf8({"HOME": "/home/vera"})
    {'HOME': '/home/vera'}
    """
    return {"PYTHONUTF8": "1", **env} if operating_system.WINDOWS else dict(env)
