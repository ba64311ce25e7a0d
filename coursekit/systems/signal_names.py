"""Signals by name and number: programs of a session know all of Linux's, whichever the system has."""

from __future__ import annotations

import enum
import signal
from typing import Any


class _Elsewhere(enum.IntEnum):
    SIGHUP = 1
    SIGQUIT = 3
    SIGABRT = 6
    SIGKILL = 9
    SIGUSR1 = 10
    SIGUSR2 = 12
    SIGCONT = 18
    SIGSTOP = 19


_KNOWN: tuple[Any, ...] = (signal.Signals, _Elsewhere)
"""The signals of this system, then those that Windows lacks."""


ABORT = 6
"""The number of SIGABRT on Linux and macOS, which ends a C++ program after an uncaught exception; on Windows it is 22."""


def signal_called(which: str | int) -> signal.Signals:
    """Return the signal with a name or number; KeyError for an unknown name, ValueError for an unknown number.

    >>> signal_called("SIGKILL").value, signal_called(2).name
    (9, 'SIGINT')
    """
    for known in _KNOWN:
        if which in (known.__members__ if isinstance(which, str) else known.__members__.values()):
            member: signal.Signals = known[which] if isinstance(which, str) else known(which)
            return member
    return signal.Signals[which] if isinstance(which, str) else signal.Signals(which)


def described(signum: int) -> str:
    """Return a shell's message about a program that was ended by this signal.

    >>> described(9)
    'Killed'
    """
    return signal.strsignal(signum) or {9: "Killed"}.get(signum, f"Unknown signal {signum}")
