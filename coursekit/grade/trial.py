"""A trial: a student's programs run on the virtual clock, and what watches them runs in another process.

The two meet on topics, services and actions only, so a program cannot change what is seen of it but by what it does.
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
"""Real seconds that the student's programs may compute without waiting."""
NOT_FOR_TRIALS = ("COURSEKIT_STOP_AFTER", "ROS_DOMAIN_ID")
"""The variables of a student's environment that a trial does without."""
WATCHER = [sys.executable, "-I", "-m", "coursekit.grade.watcher"]
PROGRAMS = [sys.executable, "-I", "-m", "coursekit.grade.programs"]
"""-I: what a student's folders hold must not stand in for modules of ours."""

__all__ = ["EVERY_NODE_S", "Plan", "Seen", "TrialFailed", "try_out"]


def try_out(plan: Plan, env: Mapping[str, str] | None = None, cwd: str | None = None) -> Seen:
    """Carry out `plan` and say what was seen; TrialFailed when it does not end in time."""
    variables = {key: value for key, value in (env or os.environ).items() if key not in NOT_FOR_TRIALS}
    done = subprocess.run(  # without a time limit: waiting for one would sleep on the session's clock
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
    """The watcher's input."""
    return json.dumps(plan, default=vars).encode()  # not `asdict`, which copies every pixel of a picture


def answered(out: bytes) -> Seen:
    """The watcher's observations; TrialFailed when the programs did not let it see."""
    try:
        found: dict[str, Any] = json.loads(out)
        if "seen" in found:
            return Seen(**found["seen"])
        why = str(found["failed"])
    except (ValueError, TypeError, KeyError):
        raise TrialFailed("the trial was ended before it could say what it saw") from None
    if why == LATE:
        never = f"your program did not give way for {GIVES_WAY:.0f} s: is there a loop that never waits?"
        raise TrialFailed(never, timed_out=True)
    if why == "it ended":
        raise TrialFailed("the program ended the trial")
    raise TrialFailed(f"the program interfered with the trial: {why}")
