"""The signals by which users and programs end a command."""

from __future__ import annotations

import signal


def endings() -> dict[int, int]:
    """Return each such signal of this system with its meaning: Windows' Ctrl-Break means Ctrl-C.

    >>> [f"{signal.Signals(came).name} is {signal.Signals(means).name}" for came, means in endings().items()][:2]
    ['SIGINT is SIGINT', 'SIGTERM is SIGTERM']
    """
    ends: dict[int, int] = {signal.SIGINT: signal.SIGINT, signal.SIGTERM: signal.SIGTERM}
    ctrl_break = getattr(signal, "SIGBREAK", None)
    return ends if ctrl_break is None else {**ends, ctrl_break: signal.SIGINT}
