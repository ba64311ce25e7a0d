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
"""Those of this system, then those that Windows lacks."""


ABORT = 6
"""How Linux and macOS number SIGABRT, with which a C++ program ends that throws; Windows has it as 22."""


def signal_called(which: str | int) -> signal.Signals:
    """The signal of a name or number; KeyError for a name and ValueError for a number that there is not.

    >>> signal_called("SIGKILL").value, signal_called(2).name
    (9, 'SIGINT')
    """
    for known in _KNOWN:
        if which in (known.__members__ if isinstance(which, str) else known.__members__.values()):
            found: signal.Signals = known[which] if isinstance(which, str) else known(which)
            return found
    return signal.Signals[which] if isinstance(which, str) else signal.Signals(which)


def described(signum: int) -> str:
    """A shell's words about a program that this signal ended.

    >>> described(9)
    'Killed'
    """
    return signal.strsignal(signum) or {9: "Killed"}.get(signum, f"Unknown signal {signum}")
