"""`check("ch02.q1")`: judge an exercise immediately, show the verdict, store the points."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from coursekit.view.progress_bar import ProgressBar
from coursekit.view.shell import running_shell
from coursekit.words.gettext import gettext

from . import events, student_name
from .cell_before import explained
from .exception_advice import cause_of, no_executable
from .exercise import Exercise, find
from .illustration import Illustration
from .interruptions import Gone, NeedsWorkspace
from .observed_work import ObservedWork
from .own_checks import OWN, fault_of, read_checks
from .progress import Progress
from .stopped_function import error_of, of_student
from .verdict import NO_HINT, CheckFailed, Skipped, Verdict, Wrong
from .work import Work

ENDLESS = "That is unusually long. If there may be a loop in your code that never ends, stop it with ■ in the toolbar above."
"""Shown during a check; the course's long ones take half a minute."""


def workspace() -> Path:
    """Return the student's workspace."""
    return Path(os.environ.get("COURSEKIT_WORKSPACE", "ros2_ws")).resolve()


def judge(
    exercise: Exercise,
    variables: Mapping[str, Any],
    folder: Path,
    tries: int = 1,
    variants: Mapping[str, Any] | None = None,
    illustration: Illustration | None = None,
) -> Verdict:
    """Judge the current work. From the second failure on, the verdict includes a hint.

    `illustration` stores the picture to draw beside the verdict.
    """
    return judge_work(exercise, _work(variables, folder, variants, illustration), tries)


def _work(
    variables: Mapping[str, Any], folder: Path, variants: Mapping[str, Any] | None, illustration: Illustration | None
) -> Work:
    work = Work(variables, folder)
    work.variants, work.illustration = variants or {}, illustration
    return work


def judge_work(exercise: Exercise, work: Any, tries: int = 1) -> Verdict:
    """Judge any work: full points require that the judge ends without an objection."""
    noted = ObservedWork(work)
    illustration = getattr(work, "illustration", None) or Illustration()
    try:
        exercise.judge(noted)
    except Wrong as wrong:
        illustration.at = wrong.at
        return _refused(exercise, wrong, noted, tries)
    except (Gone, NeedsWorkspace):
        raise
    except Skipped as skipped:
        return Verdict(exercise.name, exercise.title, 0, exercise.points, skipped=str(skipped))
    except NotImplementedError:
        illustration.forget()
        return Verdict(exercise.name, exercise.title, 0, exercise.points, "your code", "the stub is still there")
    except Exception as error:
        return _stopped(exercise, error, noted)
    return Verdict(exercise.name, exercise.title, exercise.points, exercise.points)


def _stopped(exercise: Exercise, error: Exception, noted: ObservedWork) -> Verdict:
    """Return the verdict after an exception: the student's own costs the points, the check's own is reported as such."""
    empty = Verdict(exercise.name, exercise.title, 0, exercise.points)
    if error is noted.raised or of_student(error):
        return replace(empty, expected="code that runs", got=error_of(error), timed_out=noted.timed_out())
    if isinstance(error, AssertionError):  # many other checks report failures in this way
        return replace(empty, expected=str(error)[:300] or "what the check asserts", cause=fault_of(error))
    return replace(empty, fault=fault_of(error))


def _refused(exercise: Exercise, wrong: Wrong, noted: ObservedWork, tries: int) -> Verdict:
    """Return a negative verdict; a program's fatal exception comes first, without the check's own guess."""
    died, got, cause, hint = noted.death(), wrong.got, wrong.cause, _hint(exercise.hints, wrong, tries)
    if died:
        got, cause, hint = _with_death(got, died), cause_of(died), ""
    elif missing := noted.not_found():
        cause, hint = no_executable(*missing), ""
    return Verdict(
        exercise.name,
        exercise.title,
        round(exercise.points * wrong.share, 2),
        exercise.points,
        wrong.expected,
        got,
        cause,
        hint,
        wrong.gave,
        wrong.timed_out or noted.timed_out(),
    )


def _with_death(got: str, died: str) -> str:
    """Combine the observation with the program's exception; the end of its traceback adds nothing."""
    if died in got:
        return got
    again = not got or died.partition(" (line ")[0] in got
    return f"your program raised {died}" + ("" if again else f"; {got}")


def _hint(hints: tuple[str, ...], wrong: Wrong, tries: int) -> str:
    """Return the hint for the fault from the second try on; if the judge names none, the next one with each try.

    A likely cause without a hint stands alone: a hint beside it could only be about something else.
    """
    if not hints or tries < 2 or wrong.hint == NO_HINT or (wrong.cause and wrong.hint is None):
        return ""
    return hints[min(tries - 2 if wrong.hint is None else wrong.hint, len(hints) - 1)]


def check(name: str, **variants: Any) -> None:
    """Judge exercise `name` with this notebook's variables and workspace; CheckFailed if it is not solved.

    `variants` are the values of an individual copy. The final mark uses the values known to the teacher.
    """
    progress = Progress.of_course()
    read_checks(progress.file.parent.parent / OWN)
    exercise, illustration = find(name), Illustration()
    work = _work(_variables(), workspace(), variants, illustration)
    try:
        with ProgressBar(gettext(f"Trying out {name}"), late=gettext(ENDLESS)):
            verdict = judge_work(exercise, work, progress.count_try(name))
    except KeyboardInterrupt:
        raise CheckFailed(gettext(f"{name} was stopped, so it is not judged. Is there a loop that never ends?")) from None
    verdict = explained(verdict, work.asked, running_shell())
    progress.note(verdict)
    if verdict.passed and name == student_name.EXERCISE:
        own_name = student_name.whole_name(work.variables[student_name.VARIABLE])
        student_name.keep_own_name(progress.file.parent, own_name)
    events.note(progress.file.with_name("events.jsonl"), "check", name=name, points=verdict.points)
    _show(verdict, illustration)
    if verdict.fault:
        raise CheckFailed(gettext(f"{name} is not judged: its check has a fault; the lines above say where."))
    if not verdict.passed:
        raise CheckFailed(gettext(f"{name} is not solved yet; the lines above say what is missing."))


def hint(name: str) -> str:
    """Return the first hint of an exercise, then the next one with every call."""
    exercise = find(name)
    if not exercise.hints:
        return gettext(f"{name} has no hints.")
    number = Progress.of_course().count_hint(name)
    shown = min(number, len(exercise.hints))
    return gettext(f"Hint {shown} of {len(exercise.hints)}: {exercise.hints[shown - 1]}")


def _variables() -> Mapping[str, Any]:
    shell = running_shell()
    return shell.user_ns if shell is not None else vars(sys.modules["__main__"])


class _Shown:
    """Displays a verdict as HTML and as text."""

    def __init__(self, verdict: Verdict, illustration: Illustration) -> None:
        self._verdict, self._illustration = verdict, illustration

    def _repr_html_(self) -> str:
        return self._verdict.html(self._illustration.html())

    def __repr__(self) -> str:
        return self._verdict.text()


def _show(verdict: Verdict, illustration: Illustration) -> None:
    if running_shell() is None:
        print(verdict.text())
    else:
        from IPython.display import display

        display(_Shown(verdict, illustration))
