"""The signals with which a person or a program ends a command."""

from __future__ import annotations

import signal


def endings() -> dict[int, int]:
    """Each such signal of this system, and which one it means: Windows' Ctrl-Break is one more Ctrl-C.

    >>> [f"{signal.Signals(came).name} is {signal.Signals(means).name}" for came, means in endings().items()][:2]
    ['SIGINT is SIGINT', 'SIGTERM is SIGTERM']
    """
    ends: dict[int, int] = {signal.SIGINT: signal.SIGINT, signal.SIGTERM: signal.SIGTERM}
    ctrl_break = getattr(signal, "SIGBREAK", None)
    return ends if ctrl_break is None else {**ends, ctrl_break: signal.SIGINT}
