"""Marks one submission: runs its notebooks in a sandbox and has every exercise judged from outside."""

from __future__ import annotations

import contextlib
import os
import shutil
import sys
import tempfile
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from . import sandbox
from .checking import judge_work
from .exercise import Exercise
from .inside import NOT_NEEDED
from .interruptions import Gone, NeedsWorkspace
from .parcel import other_hands, other_results, parcel_faults, read_parcel, recorded, traces
from .remote import BUILD_SECONDS, Line, RemoteWork
from .repair import Repaired, Step, repair
from .submissions import Submission, read_notebook
from .variants import Values, values_of
from .verdict import Verdict

CELL_SECONDS = 20.0
"""Seconds that a student's cell may compute."""
COURSE_SECONDS = 60.0
"""Seconds that the course's own cells may."""
FIRST_HINT = 2
"""The try from which on the first hint is given: a report gives it too."""
_SHOWS = (*NOT_NEEDED, "wait(", "graph(", "print(graph(", "terminal", "progress(", "print(terminal", "frames(",
          "evidence(", "hand_in(", "%ros2 --")  # fmt: skip


@dataclass
class Marked:
    """The outcome of one submission."""

    student: str
    digest: str
    verdicts: list[Verdict] = field(default_factory=list)
    status: str = "graded"
    tier: str = ""
    notes: list[str] = field(default_factory=list)
    """What had to be mended; the student sees it."""
    concerns: list[str] = field(default_factory=list)
    """Signs of changes, and of work that is somebody else's: for the teacher's eye only."""
    minutes_late: float = 0.0
    answers: list[str] = field(default_factory=list)
    variants: Values = field(default_factory=dict)
    """What this student's exercises asked for."""
    traces: dict[str, str] = field(default_factory=dict)
    """What no two students have alike, of a file made by `hand_in()`: digests, and of what."""

    def total(self) -> float:
        """All points."""
        return round(sum(verdict.points for verdict in self.verdicts), 2)

    def as_json(self) -> dict[str, Any]:
        """As plain values; `of_json` reads them again."""
        return asdict(self)

    @classmethod
    def of_json(cls, found: dict[str, Any]) -> Marked:
        """What `as_json` gave."""
        return cls(**{**found, "verdicts": [Verdict(**one) for one in found["verdicts"]]})


def mark(
    submission: Submission,
    sources: Mapping[str, dict[str, Any]],
    exercises: Mapping[str, Exercise],
    limits: sandbox.Limits,
) -> Marked:
    """Grade a submission; whatever is wrong with it ends up in the result, never as an exception."""
    made = Marked(submission.student, submission.digest(), tier=sandbox.tier(), variants=values_of(sources.values()))
    parcels: list[bytes] = []
    with tempfile.TemporaryDirectory(prefix="grade-") as scratch:
        try:
            parcels = submission.parcels()
            for parcel in parcels:
                made.concerns += _faults(parcel, submission.student)
            files = submission.notebooks(Path(scratch) / "unpacked")
            for name, file in _chosen(files, sources, made.notes).items():
                _mark_notebook(sources[name], file, Path(scratch) / name, exercises, limits, made)
        except ValueError as error:
            made.status, made.notes = "unreadable", [*made.notes, str(error)]
        except Exception as error:  # one bad submission never stops the class
            made.status, made.notes = "error", [*made.notes, f"{type(error).__name__}: {error}"]
    judged = {verdict.name for verdict in made.verdicts}
    made.verdicts += [_unjudged(one, "nothing was handed in") for name, one in exercises.items() if name not in judged]
    made.verdicts.sort(key=lambda verdict: verdict.name)
    for parcel in parcels:
        _compare(parcel, made)
    if not judged and made.status == "graded":
        made.status = "empty"
    return made


def _faults(parcel: bytes, name: str) -> list[str]:
    """Signs that a file made by `hand_in()` was changed, or is somebody else's."""
    found = parcel_faults(parcel)
    with contextlib.suppress(ValueError):
        found += other_hands(parcel, name)
    return found


def _compare(parcel: bytes, made: Marked) -> None:
    """Say where the marks that are recorded in a parcel are not those of this run, and keep what tells copies."""
    with contextlib.suppress(ValueError):
        manifest, _ = read_parcel(parcel)
        said = recorded(manifest)
        earned = {one.name: one.points for one in made.verdicts if one.name in said}
        made.concerns += other_results(manifest, earned)
        made.traces |= traces(parcel)


def _chosen(files: list[Path], sources: Mapping[str, Any], notes: list[str]) -> dict[str, Path]:
    """Which file is which notebook of the course: by name, of several the newest."""
    found: dict[str, Path] = {}
    for file in sorted(files, key=lambda one: one.stat().st_mtime):
        names = [name for name in sources if file.name == name or file.stem.startswith(Path(name).stem)]
        if not names and len(sources) == 1:
            names = list(sources)
            notes.append(f"{file.name}: taken as {names[0]}")
        for name in names:
            if name in found:
                notes.append(f"{name}: handed in more than once; {file.name} counts")
            found[name] = file
    return found


def _mark_notebook(
    source: dict[str, Any],
    file: Path,
    folder: Path,
    exercises: Mapping[str, Exercise],
    limits: sandbox.Limits,
    made: Marked,
) -> None:
    repaired = repair(source, read_notebook(file))
    made.notes += repaired.notes
    made.answers += repaired.answers()
    workspace = folder / "course" / "ros2_ws"
    (workspace / "src").mkdir(parents=True)
    env = _environment(workspace)
    running = sandbox.start([sys.executable, "-m", "coursekit.grade.inside"], workspace.parent, env, limits)
    try:
        work = RemoteWork(Line(running, limits), workspace, env, limits, made.variants)
        made.verdicts += _run_and_judge(repaired, work, exercises)
    finally:
        running.end()
        shutil.rmtree(folder, ignore_errors=True)


def _environment(workspace: Path) -> dict[str, str]:
    from coursekit.packages.environment import source_underlay

    env = {name: value for name, value in os.environ.items() if not name.startswith("COURSEKIT_")}
    source_underlay(env)
    return env | {"COURSEKIT_COURSE": str(workspace.parent), "COURSEKIT_WORKSPACE": str(workspace), "COURSEKIT_GRADING": "1"}


def _run_and_judge(repaired: Repaired, work: RemoteWork, exercises: Mapping[str, Exercise]) -> list[Verdict]:
    """Values are judged where their check stands; files and programs at the end, after one build."""
    verdicts: list[Verdict] = []
    later: list[str] = []
    wanted = [step.exercise for step in repaired.steps if step.exercise in exercises]
    try:
        for step in repaired.steps:
            if not repaired.begun.get(step.exercise, True):
                verdicts.append(_unjudged(exercises[step.exercise], "the cell as it was handed out"))
            elif step.exercise in exercises:
                work.judge_from_here(step.exercise)
                try:
                    verdicts.append(judge_work(exercises[step.exercise], work, FIRST_HINT))
                except NeedsWorkspace:
                    later.append(step.exercise)
            elif source := _needed(step):
                work.run(source, CELL_SECONDS if step.solution else COURSE_SECONDS)
        work.build(BUILD_SECONDS)
        for name in later:
            work.judge_from_here(name)
            verdicts.append(judge_work(exercises[name], work, FIRST_HINT))
    except Gone as gone:
        judged = {verdict.name for verdict in verdicts}
        verdicts += [_unjudged(exercises[name], str(gone)) for name in wanted if name not in judged]
    return verdicts


def _needed(step: Step) -> str:
    """What is run of a cell: of the course's own not the lines that only show something."""
    if step.solution:
        return step.source
    lines = step.source.splitlines()
    kept = [line for line in lines if not line.startswith(_SHOWS) or line.count("(") != line.count(")")]
    return "\n".join(kept).strip()


def _unjudged(exercise: Exercise, why: str) -> Verdict:
    hint = next(iter(exercise.hints), "")
    return Verdict(exercise.name, exercise.title, 0, exercise.points, "your work", why, hint=hint)
