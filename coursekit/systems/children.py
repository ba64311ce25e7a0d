"""Child processes: how they begin so that a Ctrl-C reaches them alone, and how signals and text come to them."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
from collections.abc import Mapping
from typing import Any

from . import which

CTRL_BREAK: int = getattr(signal, "CTRL_BREAK_EVENT", 1)
"""The signal in place of Ctrl-C on Windows, where Ctrl-C itself goes to nobody or to all of a console."""
_NEW_GROUP: int = getattr(subprocess, "CREATE_NEW_PROCESS_GROUP", 0x200)


def apart() -> dict[str, Any]:
    """The words of `subprocess.Popen` that keep a child from hearing this program's Ctrl-C.

    >>> apart()
    {'start_new_session': True}
    """
    return {"creationflags": _NEW_GROUP} if which.WINDOWS else {"start_new_session": True}


def send_signal(child: subprocess.Popen[Any], signum: int) -> None:
    """Give a signal to a child that began `apart`, and to what it started; nothing when it has ended.

    Windows knows two: SIGINT becomes Ctrl-Break, every other one ends the child at once.
    """
    if which.WINDOWS:
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
    except (OSError, SystemError):  # os.kill gives the second kind when it fails
        pass  # this program has no console through which it could go
    with contextlib.suppress(OSError):
        child.terminate()


def end_family(child: subprocess.Popen[Any]) -> None:
    """End a child that began `apart`, and all that it has started, at once."""
    if which.WINDOWS:
        with contextlib.suppress(OSError):
            subprocess.run(["taskkill", "/F", "/T", "/PID", str(child.pid)], stdin=subprocess.DEVNULL, capture_output=True)
    else:
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(child.pid, signal.SIGKILL)
    with contextlib.suppress(OSError):
        child.kill()


def interrupt_self() -> None:
    """Press Ctrl-C in this program; from any thread, and its main one sees it."""
    if which.WINDOWS:  # os.kill would end the program there
        signal.raise_signal(signal.SIGINT)
    else:
        os.kill(os.getpid(), signal.SIGINT)


def with_utf8(env: Mapping[str, str]) -> dict[str, str]:
    """The environment in which a child that is a Python program writes UTF-8 to pipes, as it does on Linux.

    >>> with_utf8({"HOME": "/home/vera"})
    {'HOME': '/home/vera'}
    """
    return {"PYTHONUTF8": "1", **env} if which.WINDOWS else dict(env)
