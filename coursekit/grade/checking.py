"""`check("ch02.q1")`: judge an exercise here and now, show the verdict, remember the points."""

from __future__ import annotations

import os
import traceback
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from coursekit.view.working import Working

from . import events
from .exercise import Exercise, find
from .interruptions import Gone, NeedsWorkspace
from .progress import Progress
from .verdict import CheckFailed, Verdict, Wrong
from .work import Work


def workspace() -> Path:
    """The student's workspace."""
    return Path(os.environ.get("COURSEKIT_WORKSPACE", "ros2_ws")).resolve()


def judge(
    exercise: Exercise,
    variables: Mapping[str, Any],
    folder: Path,
    tries: int = 1,
    variants: Mapping[str, Any] | None = None,
) -> Verdict:
    """The verdict on the work as it is now. After the second failure a hint is given, with each further one the next."""
    work = Work(variables, folder)
    work.variants = variants or {}
    return judge_work(exercise, work, tries)


def judge_work(exercise: Exercise, work: Work, tries: int = 1) -> Verdict:
    """The verdict on work wherever it is."""
    try:
        exercise.judge(work)
    except Wrong as wrong:
        hints = exercise.hints
        hint = hints[min(tries - 2, len(hints) - 1)] if hints and tries >= 2 else ""
        return Verdict(
            exercise.name,
            exercise.title,
            round(exercise.points * wrong.share, 2),
            exercise.points,
            wrong.expected,
            wrong.got,
            wrong.cause,
            hint,
        )
    except (Gone, NeedsWorkspace):
        raise
    except NotImplementedError:
        return Verdict(exercise.name, exercise.title, 0, exercise.points, "your code", "the stub is still there")
    except Exception as error:
        where = traceback.extract_tb(error.__traceback__)[-1]
        seen = f"{type(error).__name__}: {error} (line {where.lineno} of {Path(where.filename).name})"
        return Verdict(exercise.name, exercise.title, 0, exercise.points, "code that runs", seen)
    return Verdict(exercise.name, exercise.title, exercise.points, exercise.points)


def check(name: str, **variants: Any) -> None:
    """Judge exercise `name` with what is in this notebook and workspace; CheckFailed if it is not solved.

    `variants` are the values of a copy that asks for values of its own. The mark is found with those that the teacher knows.
    """
    exercise = find(name)
    progress = Progress.of_course()
    with Working(f"Trying out {name}"):
        verdict = judge(exercise, _variables(), workspace(), progress.count_try(name), variants)
    progress.note(verdict)
    events.note(progress.file.with_name("events.jsonl"), "check", name=name, points=verdict.points)
    _show(verdict)
    if not verdict.passed:
        raise CheckFailed(f"{name} is not solved yet; the lines above say what is missing.")


def hint(name: str) -> str:
    """The first hint of an exercise, the next one with every call."""
    exercise = find(name)
    if not exercise.hints:
        return f"{name} has no hints."
    number = Progress.of_course().count_hint(name)
    shown = min(number, len(exercise.hints))
    return f"Hint {shown} of {len(exercise.hints)}: {exercise.hints[shown - 1]}"


def _variables() -> Mapping[str, Any]:
    import sys

    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return shell.user_ns if shell is not None else vars(sys.modules["__main__"])


class _Shown:
    """Displays a verdict in both forms."""

    def __init__(self, verdict: Verdict) -> None:
        self._verdict = verdict

    def _repr_html_(self) -> str:
        return self._verdict.html()

    def __repr__(self) -> str:
        return self._verdict.text()


def _show(verdict: Verdict) -> None:
    from IPython import get_ipython
    from IPython.display import display

    if get_ipython() is None:
        print(verdict.text())
    else:
        display(_Shown(verdict))
