"""A trial: a student's programs run on the virtual clock, observed from another process.

Both sides share only topics, services and actions, so a program can affect the observations only by its behaviour.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Mapping
from typing import Any

from coursekit.joined.pipe import LATE

from .plan import EVERY_NODE_S, Plan, Seen, TrialFailed

GIVES_WAY = 30.0
"""The real time that the student's programs may compute without waiting [s]."""
NOT_FOR_TRIALS = ("COURSEKIT_STOP_AFTER", "ROS_DOMAIN_ID")
"""Variables removed from the student's environment for a trial."""
WATCHER = [sys.executable, "-I", "-m", "coursekit.grade.watcher"]
PROGRAMS = [sys.executable, "-I", "-m", "coursekit.grade.programs"]
"""-I: files in a student's folders must not replace coursekit's modules."""

__all__ = ["EVERY_NODE_S", "Plan", "Seen", "TrialFailed", "try_out"]


def try_out(plan: Plan, env: Mapping[str, str] | None = None, cwd: str | None = None) -> Seen:
    """Carry out `plan` and return the observations; TrialFailed when it does not end in time."""
    variables = {key: value for key, value in (env or os.environ).items() if key not in NOT_FOR_TRIALS}
    done = subprocess.run(  # without a timeout, which would sleep on the session's clock
        [*WATCHER, str(GIVES_WAY)],
        input=question(plan),
        env=variables | {"COURSEKIT_TIME": "virtual", "PYTHONDONTWRITEBYTECODE": "1"},
        cwd=cwd,
        capture_output=True,
    )
    if done.returncode:
        said = done.stderr.decode(errors="replace").strip()
        raise TrialFailed(said.splitlines()[-1] if said else "it ended abruptly")
    return answered(done.stdout)


def question(plan: Plan) -> bytes:
    """Return the watcher's input."""
    return json.dumps(plan, default=vars).encode()  # not `asdict`, which copies every pixel of an image


def answered(out: bytes) -> Seen:
    """Parse the watcher's observations; TrialFailed when the programs prevented them."""
    try:
        answer: dict[str, Any] = json.loads(out)
        if "seen" in answer:
            return Seen(**answer["seen"])
        why = str(answer["failed"])
    except (ValueError, TypeError, KeyError):
        raise TrialFailed("the trial was ended before it could say what it saw") from None
    if why == LATE:
        never = f"your program did not give way for {GIVES_WAY:.0f} s: is there a loop that never waits?"
        raise TrialFailed(never, timed_out=True)
    if why == "it ended":
        raise TrialFailed("the program ended the trial")
    raise TrialFailed(f"the program interfered with the trial: {why}")
