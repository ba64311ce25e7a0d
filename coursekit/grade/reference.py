"""Check before marking that the grader gives the course's own solutions all points."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from . import sandbox
from .copy import without_solution
from .exercise import Exercise
from .mark import Marked
from .recognising import text_of
from .results import Results, key_of
from .submissions import Submission

KEY = "the-reference"


class GraderBroken(Exception):
    """The grader does not give the reference solution all points, so its marks would be wrong."""

    def __init__(self, why: str, cure: str = "`coursekit doctor` looks for the cause.") -> None:
        super().__init__(why)
        self.cure = cure


@dataclass(frozen=True)
class Reference:
    """The course's own solution of a chapter, and the data for marking it."""

    chapter: str
    source: dict[str, Any]
    exercises: Mapping[str, Exercise]
    scratch: Path
    limits: sandbox.Limits
    dice: bytes

    def submission(self) -> Submission:
        """Return the solution as a submission."""
        file = self.scratch / "reference" / self.chapter
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(json.dumps(self.source), encoding="utf-8")
        return Submission("the reference solution", file, {self.chapter: file})


def expect_sound(reference: Reference, results: Results, mark: Callable[..., Marked]) -> str:
    """Mark a chapter's reference solution once per state of the grader. Returns a message if there is none.

    Raises:
        GraderBroken: when it does not get all points.
    """
    chapter, source, exercises = reference.chapter, reference.source, reference.exercises
    if not exercises:
        return ""
    if not has_solutions(source):
        return f"{chapter} is here without its solutions: that the grader gives them all points was not tried."
    submission = reference.submission()
    depends = key_of(submission.digest(), source, exercises, sandbox.tier(), reference.dice)
    marked = results.read(KEY, chapter, depends)
    if marked is None:
        marked = mark(submission, {chapter: source}, exercises, reference.limits, reference.dice)
    lost = [verdict for verdict in marked.verdicts if not verdict.passed]
    if lost or marked.status != "graded":
        first = lost[0].text() if lost else "; ".join(marked.notes) or marked.status
        faulty = [verdict for verdict in lost if verdict.fault]
        if faulty:
            raise GraderBroken(f"the check of {faulty[0].name} has a fault: {faulty[0].fault}.", "Mend the check first.")
        points = f"{marked.total():g} of {sum(verdict.of for verdict in marked.verdicts):g} points"
        raise GraderBroken(f"the reference solution of {chapter} gets {points}.\n{first}")
    results.write(KEY, chapter, depends, marked)
    return ""


def has_solutions(source: Mapping[str, Any]) -> bool:
    """Whether a course notebook contains its solutions; those installed for students do not."""
    return any(without_solution(text) != text for text in map(text_of, source["cells"]))
