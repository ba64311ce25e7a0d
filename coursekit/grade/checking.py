"""`check("ch02.q1")`: judge an exercise here and now, show the verdict, remember the points."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from coursekit.view.shell import running_shell
from coursekit.view.working import Working
from coursekit.words.gettext import gettext

from . import events
from .deaths import cause_of
from .exercise import Exercise, find
from .illustration import Illustration
from .interruptions import Gone, NeedsWorkspace
from .noted import NotedWork
from .own_checks import OWN, fault_of, read_checks
from .plain import error_of, of_student
from .progress import Progress
from .verdict import NO_HINT, CheckFailed, Skipped, Verdict, Wrong
from .work import Work

ENDLESS = "That is unusually long. If there may be a loop in your code that never ends, stop it with ■ in the toolbar above."
"""Said while a check lasts; long ones of the course take half a minute."""


def workspace() -> Path:
    """The student's workspace."""
    return Path(os.environ.get("COURSEKIT_WORKSPACE", "ros2_ws")).resolve()


def judge(
    exercise: Exercise,
    variables: Mapping[str, Any],
    folder: Path,
    tries: int = 1,
    variants: Mapping[str, Any] | None = None,
    illustration: Illustration | None = None,
) -> Verdict:
    """The verdict on the work as it is now. From the second failure on a hint is given.

    `illustration` keeps what is to be drawn beside the verdict.
    """
    work = Work(variables, folder)
    work.variants, work.illustration = variants or {}, illustration
    return judge_work(exercise, work, tries)


def judge_work(exercise: Exercise, work: Any, tries: int = 1) -> Verdict:
    """The verdict on work wherever it is: all points only when its judge came to an end without an objection."""
    noted = NotedWork(work)
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


def _stopped(exercise: Exercise, error: Exception, noted: NotedWork) -> Verdict:
    """The verdict where an exception ended the check: the work's own costs the points, the check's own is told as such."""
    empty = Verdict(exercise.name, exercise.title, 0, exercise.points)
    if error is noted.raised or of_student(error):
        return replace(empty, expected="code that runs", got=error_of(error), timed_out=noted.timed_out())
    if isinstance(error, AssertionError):  # the way in which many checks elsewhere say that something is wrong
        return replace(empty, expected=str(error)[:300] or "what the check asserts", cause=fault_of(error))
    return replace(empty, fault=fault_of(error))


def _refused(exercise: Exercise, wrong: Wrong, noted: NotedWork, tries: int) -> Verdict:
    """The verdict that says what is wrong; what a program died of comes first, and no guess of the check's beside it."""
    died, got, cause, hint = noted.death(), wrong.got, wrong.cause, _hint(exercise.hints, wrong, tries)
    if died:
        got, cause, hint = _with_death(got, died), cause_of(died), ""
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
    """The observation, with the exception of the program; the end of its traceback says nothing more."""
    if died in got:
        return got
    again = not got or died.partition(" (line ")[0] in got
    return f"your program raised {died}" + ("" if again else f"; {got}")


def _hint(hints: tuple[str, ...], wrong: Wrong, tries: int) -> str:
    """From the second try on the hint that fits the fault; where the judge cannot tell, with each try the next one.

    A likely cause that names no hint is what there is to say: a hint beside it could only be about something else.
    """
    if not hints or tries < 2 or wrong.hint == NO_HINT or (wrong.cause and wrong.hint is None):
        return ""
    return hints[min(tries - 2 if wrong.hint is None else wrong.hint, len(hints) - 1)]


def check(name: str, **variants: Any) -> None:
    """Judge exercise `name` with what is in this notebook and workspace; CheckFailed if it is not solved.

    `variants` are the values of a copy that asks for values of its own. The mark is found with those that the teacher knows.
    """
    progress = Progress.of_course()
    read_checks(progress.file.parent.parent / OWN)
    exercise, illustration = find(name), Illustration()
    try:
        with Working(gettext(f"Trying out {name}"), late=gettext(ENDLESS)):
            verdict = judge(exercise, _variables(), workspace(), progress.count_try(name), variants, illustration)
    except KeyboardInterrupt:
        raise CheckFailed(gettext(f"{name} was stopped, so it is not judged. Is there a loop that never ends?")) from None
    verdict = _with_cell_before(verdict, _fault_before())
    progress.note(verdict)
    events.note(progress.file.with_name("events.jsonl"), "check", name=name, points=verdict.points)
    _show(verdict, illustration)
    if verdict.fault:
        raise CheckFailed(gettext(f"{name} is not judged: its check has a fault; the lines above say where."))
    if not verdict.passed:
        raise CheckFailed(gettext(f"{name} is not solved yet; the lines above say what is missing."))


def hint(name: str) -> str:
    """The first hint of an exercise, the next one with every call."""
    exercise = find(name)
    if not exercise.hints:
        return gettext(f"{name} has no hints.")
    number = Progress.of_course().count_hint(name)
    shown = min(number, len(exercise.hints))
    return gettext(f"Hint {shown} of {len(exercise.hints)}: {exercise.hints[shown - 1]}")


def _with_cell_before(verdict: Verdict, fault: str) -> Verdict:
    """Where the cell before the check stopped with an error, an older answer was judged: that is told first."""
    if verdict.passed or verdict.fault or not fault:
        return verdict
    cause = f"The cell before this check stopped with {fault}. What was judged is older: mend that cell and run it."
    return replace(verdict, cause=cause, hint="")


def _fault_before() -> str:
    """The error of the cell that was run before this one, empty where it ran to its end or was a check."""
    before = getattr(running_shell(), "last_execution_result", None)
    error = before and (before.error_before_exec or before.error_in_exec)
    if not isinstance(error, Exception) or isinstance(error, CheckFailed):
        return ""
    line = f" in its line {error.lineno}" if isinstance(error, SyntaxError) and error.lineno else ""
    said = f"{type(error).__name__}: {error.msg if isinstance(error, SyntaxError) else error}"
    return said[:200].removesuffix(": ") + line  # a stub's error has no text


def _variables() -> Mapping[str, Any]:
    shell = running_shell()
    return shell.user_ns if shell is not None else vars(sys.modules["__main__"])


class _Shown:
    """Displays a verdict in both forms."""

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
