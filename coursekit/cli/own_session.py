"""Run a command in a session of this interpreter, with output to this terminal."""

from __future__ import annotations

import signal
import sys
from collections.abc import Sequence
from typing import Any

from coursekit.processes.session import Session
from coursekit.processes.signal_waker import SignalWaker
from coursekit.systems import operating_system
from coursekit.systems.ending_signals import endings

from .parser import run


def run_in(session: Session, argv: Sequence[str]) -> int:
    """Run `ros2 ARGV` as the session's only command, forwarding Ctrl-C. Returns its exit code."""
    out, err = sys.stdout, sys.stderr

    def show(stream: str, text: str) -> None:
        target = out if stream == "stdout" else err
        target.write(text)
        target.flush()

    process = session.start(lambda: run(argv), name="ros2", argv=list(argv), on_output=show)

    def forward(signum: int, _frame: Any) -> None:
        process.send_signal(endings()[signum])
        if session.clock.virtual:
            session.clock.wake()

    for number in endings():
        signal.signal(number, forward)
    waker = None if operating_system.WINDOWS or session.clock.virtual else SignalWaker()
    code = process.wait()
    if waker is not None:
        waker.close()
    session.close()
    return 0 if code is None else code
