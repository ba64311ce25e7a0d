"""Mark one submission: each chapter is examined by its own process, which is ended when it exceeds a limit."""

from __future__ import annotations

import contextlib
import tempfile
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

from . import folders, sandbox
from .bundle import bundle_faults, other_hands, other_results, read_bundle, recorded, traces
from .examiner import Examined, Task, examine, unjudged
from .exercise import Exercise
from .own_checks import own_files
from .submissions import Submission
from .variants import Values, values_of
from .verdict import Verdict


@dataclass
class Marked:
    """The outcome of one submission."""

    student: str
    digest: str
    verdicts: list[Verdict] = field(default_factory=list)
    status: str = "graded"
    tier: str = ""
    notes: list[str] = field(default_factory=list)
    """The repairs, shown to the student."""
    concerns: list[str] = field(default_factory=list)
    """Signs of changes and of other people's work, for the teacher only."""
    minutes_late: float = 0.0
    answers: list[str] = field(default_factory=list)
    variants: Values = field(default_factory=dict)
    """The variants of this student's exercises."""
    traces: dict[str, str] = field(default_factory=dict)
    """The digests unique to a student's `hand_in()` file, with the names of the parts."""

    def total(self) -> float:
        """Return the sum of the points."""
        return round(sum(verdict.points for verdict in self.verdicts), 2)

    def as_json(self) -> dict[str, Any]:
        """Return plain values, which `of_json` reads."""
        return asdict(self)

    @classmethod
    def of_json(cls, found: dict[str, Any]) -> Marked:
        """Make a mark from the dictionary of `as_json`."""
        return cls(**{**found, "verdicts": [Verdict(**verdict) for verdict in found["verdicts"]]})


def mark(
    submission: Submission,
    sources: Mapping[str, dict[str, Any]],
    exercises: Mapping[str, Exercise],
    limits: sandbox.Limits,
    secret: bytes = b"",
) -> Marked:
    """Grade a submission; every fault ends up in the result, never as an exception.

    `secret` seeds the judges' random choices, which are unpredictable without it.
    """
    limits = replace(limits, tier=sandbox.tier())  # the tier named in the result, also in other processes
    marked = Marked(submission.student, submission.digest(), tier=limits.tier, variants=values_of(sources.values()))
    bundles: list[bytes] = []
    scratch = Path(tempfile.mkdtemp(prefix="grade-"))
    try:
        bundles = submission.bundles()
        for bundle in bundles:
            marked.concerns += _faults(bundle, submission.student)
        files = submission.notebooks(scratch / "unpacked")
        own = sorted({str(source.parent) for source in own_files(exercises.values())})
        for name, file in _chosen(files, sources, marked.notes).items():
            folder, names = str(scratch / name), list(exercises)
            task = Task(sources[name], str(file), folder, names, marked.variants, asdict(limits), secret.hex(), own)
            _add(marked, name, examine(task, limits))
    except ValueError as error:
        marked.status, marked.notes = "unreadable", [*marked.notes, str(error)]
    except Exception as error:  # one bad submission must never stop the class
        marked.status, marked.notes = "error", [*marked.notes, f"{type(error).__name__}: {error}"]
    finally:
        folders.remove(scratch)
    judged = {verdict.name for verdict in marked.verdicts}
    missing = "what was handed in could not be read" if marked.status == "unreadable" else "nothing was handed in"
    marked.verdicts += [unjudged(exercise, missing) for name, exercise in exercises.items() if name not in judged]
    marked.verdicts.sort(key=lambda verdict: verdict.name)
    for bundle in bundles:
        _compare(bundle, marked)
    if not judged and marked.status == "graded":
        marked.status = "empty"
    return marked


def _add(marked: Marked, name: str, examined: Examined) -> None:
    """Add the findings of one chapter."""
    marked.verdicts += examined.verdicts
    marked.notes += examined.notes
    marked.answers += examined.answers
    if examined.failed:
        marked.status = "unreadable" if examined.unreadable else "error"
        marked.notes.append(f"{name}: {examined.failed}")


def _faults(bundle: bytes, name: str) -> list[str]:
    """Return signs that a file made by `hand_in()` was changed, or belongs to another student."""
    faults = bundle_faults(bundle)
    with contextlib.suppress(ValueError):
        faults += other_hands(bundle, name)
    return faults


def _compare(bundle: bytes, marked: Marked) -> None:
    """Report differences between the recorded marks of a bundle and this run, and store its traces."""
    with contextlib.suppress(ValueError):
        manifest, _ = read_bundle(bundle)
        said = recorded(manifest)
        earned = {verdict.name: verdict.points for verdict in marked.verdicts if verdict.name in said}
        marked.concerns += other_results(manifest, earned)
        marked.traces |= traces(bundle)


def _chosen(files: list[Path], sources: Mapping[str, Any], notes: list[str]) -> dict[str, Path]:
    """Assign files to the course's notebooks by name, preferring the newest."""
    chosen: dict[str, Path] = {}
    for file in sorted(files, key=lambda file: file.stat().st_mtime):
        names = [name for name in sources if file.name == name or file.stem.startswith(Path(name).stem)]
        if not names and len(sources) == 1:
            names = list(sources)
            notes.append(f"{file.name}: taken as {names[0]}")
        for name in names:
            if name in chosen:
                notes.append(f"{name}: handed in more than once; {file.name} counts")
            chosen[name] = file
    return chosen
