"""Examine one chapter of one submission in its own process: the input is hostile, so it can be ended at any time.

`python -I -m coursekit.grade.examiner` reads a task as JSON on stdin, and writes the findings to stdout.
"""

from __future__ import annotations

import os
import subprocess
import sys
import threading
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from coursekit.systems.children import apart

from . import sandbox
from .checking import judge_work
from .exercise import Exercise, find
from .interruptions import Gone, NeedsWorkspace
from .limited import end_with_parent
from .own_checks import read_checks
from .remote import RemoteWork
from .repair import Repaired, repair
from .sandbox_facts import as_json, checked
from .submissions import read_notebook
from .verdict import Verdict
from .work import NOTHING

FIRST_HINT = 2
"""The try from which the first hint is given, so that a report includes it."""
MOST = 16 << 20
"""The maximum size of an examination's output [bytes]."""
MEMORY = 8 << 30
"""The address space of an examiner [bytes]."""
LONGEST = 2000
"""The maximum length of a sentence that quotes a student's work [characters]."""


@dataclass
class Task:
    """An examination: the course's notebook, the student's, an empty folder, and the exercises."""

    source: dict[str, Any]
    file: str
    folder: str
    exercises: list[str]
    variants: dict[str, dict[str, Any]]
    limits: dict[str, Any]
    secret: str = ""
    """In hexadecimal."""
    checks: list[str] = field(default_factory=list)
    """Folders of additional checks beside the course's own."""


@dataclass
class Examined:
    """The findings."""

    verdicts: list[Verdict] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    answers: list[str] = field(default_factory=list)
    failed: str = ""
    """Why there are no findings, or not all."""
    unreadable: bool = False
    """Whether that is the notebook's fault."""


def examine(task: Task, limits: sandbox.Limits) -> Examined:
    """Have a chapter examined; there is always an answer in bounded time, whatever happens to the examiner."""
    child = subprocess.Popen(
        [sys.executable, "-I", "-m", "coursekit.grade.examiner"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        **apart(),
    )
    running = sandbox.Sandboxed(child)
    timer = threading.Timer(limits.chapter, running.end, [f"marking it took longer than {limits.chapter:g} s"])
    timer.daemon = True
    timer.start()
    try:
        out = running.answer(as_json(task).encode(), MOST)
        examined = checked(Examined, out)
    except ValueError:
        return Examined(failed=running.stopped or "it could not be marked: what marks it was ended by it")
    finally:
        timer.cancel()
        running.end()
    known = {name: find(name) for name in task.exercises}
    if any(
        verdict.name not in known or not 0 <= verdict.points <= known[verdict.name].points for verdict in examined.verdicts
    ):
        return Examined(failed="it could not be marked: the marks are none that there are")
    return examined


def unjudged(exercise: Exercise, why: str) -> Verdict:
    """Return a verdict without points, for a reason outside of the exercise."""
    hint = next(iter(exercise.hints), "")
    return Verdict(exercise.name, exercise.title, 0, exercise.points, "your work", why, hint=hint)


def main() -> int:
    """Run one task."""
    end_with_parent()
    _limit_memory()
    task = checked(Task, sys.stdin.buffer.read())
    for folder in task.checks:
        read_checks(Path(folder))
    out = os.dup(1)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    try:
        examined = _examined(task)
    except ValueError as error:
        examined = Examined(failed=str(error)[:LONGEST], unreadable=True)
    with os.fdopen(out, "wb") as answer:
        answer.write(as_json(examined).encode())
    os._exit(0)


def _limit_memory() -> None:
    try:
        import resource
    except ImportError:  # Windows: the container is the only limit
        return
    _, hard = resource.getrlimit(resource.RLIMIT_AS)
    most = MEMORY if hard == resource.RLIM_INFINITY else min(MEMORY, hard)
    resource.setrlimit(resource.RLIMIT_AS, (most, hard))


def _examined(task: Task) -> Examined:
    repaired = repair(task.source, read_notebook(Path(task.file)))
    examined = Examined(notes=repaired.notes, answers=repaired.answers())
    limits = sandbox.Limits(**task.limits)
    workspace = Path(task.folder) / "course" / "ros2_ws"
    (workspace / "src").mkdir(parents=True)
    env = environment(workspace)
    running = sandbox.start([sys.executable, "-m", "coursekit.grade.sandbox_program"], workspace.parent, env, limits)
    work = RemoteWork(running, workspace, env, limits, task.variants, bytes.fromhex(task.secret))
    try:
        exercises = {name: find(name) for name in task.exercises}
        examined.verdicts = _run_and_judge(repaired, work, exercises, limits)
    finally:
        work.end()
    return examined


def environment(workspace: Path) -> dict[str, str]:
    """Return the environment of programs in a sandbox, with the course and a workspace."""
    from coursekit.packages.environment import source_underlay

    env = {name: value for name, value in os.environ.items() if not name.startswith("COURSEKIT_")}
    source_underlay(env)
    return env | {"COURSEKIT_COURSE": str(workspace.parent), "COURSEKIT_WORKSPACE": str(workspace), "COURSEKIT_GRADING": "1"}


def _run_and_judge(
    repaired: Repaired, work: RemoteWork, exercises: Mapping[str, Exercise], limits: sandbox.Limits
) -> list[Verdict]:
    """Judge values at their check; files and programs at the end, after one build."""
    verdicts: list[Verdict] = []
    later: list[str] = []
    stopped, over = "", False
    wanted = [step.exercise for step in repaired.steps if step.exercise in exercises]
    try:
        for step in repaired.steps:
            if step.exercise in exercises and not repaired.begun.get(step.exercise, True):
                verdicts.append(unjudged(exercises[step.exercise], "the cell as it was handed out"))
            elif step.exercise in exercises:
                work.judge_from_here(step.exercise)
                try:
                    verdicts.append(_explained(_judged(exercises[step.exercise], work), stopped, over))
                except NeedsWorkspace:
                    later.append(step.exercise)
                stopped, over = "", False
            elif step.source.strip():
                error = work.run(step.source, limits.cell if step.solution else limits.course_cell)
                if step.solution:
                    stopped, over = error, work.cell_timed_out
        work.finish(limits.build)
        for name in later:
            work.judge_from_here(name)
            verdicts.append(_built_or_late(_judged(exercises[name], work), work))
    except Gone as gone:
        judged = {verdict.name for verdict in verdicts}
        left = [unjudged(exercises[name], str(gone)) for name in wanted if name not in judged]
        verdicts += [replace(verdict, timed_out=gone.timed_out) for verdict in left]
    return verdicts


def _built_or_late(verdict: Verdict, work: RemoteWork) -> Verdict:
    """Mark a verdict after an unfinished build: it does not blame the student, since a busy computer may cause that."""
    if verdict.passed or not work.build_timed_out:
        return verdict
    why = "The build took longer than it may. Does a setup.py never end? If the computer was busy, mark this student again."
    return replace(verdict, timed_out=True, cause=why)


def _explained(verdict: Verdict, stopped: str, over: bool) -> Verdict:
    """Use the cell's own error as the cause: a syntax error leaves no values behind."""
    if not stopped or verdict.passed:
        return verdict
    verdict = replace(verdict, timed_out=verdict.timed_out or over)
    if verdict.got != NOTHING:
        return verdict
    why = "The cell took longer than it may. Is there a loop that never ends?" if over else f"The cell stopped: {stopped}"
    return replace(verdict, cause=_plain(why))


def _judged(exercise: Exercise, work: RemoteWork) -> Verdict:
    verdict = judge_work(exercise, work, FIRST_HINT)
    return replace(
        verdict,
        expected=_plain(verdict.expected),
        got=_plain(verdict.got),
        cause=_plain(verdict.cause),
        hint=_plain(verdict.hint),
        gave=_plain(verdict.gave),
        fault=_plain(verdict.fault),
    )


def _plain(text: str) -> str:
    """Return a quote of a student's work with bounded length and only valid characters."""
    return text[:LONGEST].encode("utf-8", "replace").decode()


if __name__ == "__main__":
    sys.exit(main())
