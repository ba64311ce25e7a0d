"""One person's record: the submission, the marks of its chapters, lateness, and changes by hand."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import PurePosixPath
from time import time as now

from coursekit.words.gettext import ENGLISH

from .lateness import DAY_S, Policy
from .mark import Marked
from .person_submission import PersonSubmission
from .sanitizing import number, unique
from .statuses import status_of
from .submission_parts import SEALED, told_time
from .verdict import Verdict

COMMENT = "comment"
"""The column of the teacher's comment for the student."""
ON_EXERCISE = " comment"
"""The suffix of a column with a comment on one exercise: `ch02.q1 comment`."""


@dataclass
class Late:
    """The lateness of one chapter, and the source of its time."""

    minutes: float = 0.0
    when: float = 0.0
    when_from: str = ""
    percent_off: float = 0.0


@dataclass
class Record:
    """A person, with all data of the marks."""

    handed: PersonSubmission
    wanted: Mapping[str, Sequence[Verdict]]
    """The exercises by chapter, without points so far."""
    marks: dict[str, Marked] = field(default_factory=dict)
    late: dict[str, Late] = field(default_factory=dict)
    tier: str = ""
    by_hand: dict[str, float] = field(default_factory=dict)
    """Points written into the table by the teacher, by exercise; `total` for the sum."""
    extra: dict[str, str] = field(default_factory=dict)
    """The teacher's texts in additional columns."""

    @property
    def label(self) -> str:
        """The person's name."""
        return self.handed.label

    @property
    def key(self) -> str:
        """The name of the person's files."""
        return self.handed.key

    def language(self) -> str:
        """Return the language of the submitted notebooks; English if none has one."""
        return next((piece.known.language for piece in self.handed.chosen.values() if piece.known.language), ENGLISH)

    def chapters(self) -> list[str]:
        """Return the chapters of the run that the person handed in."""
        return [name for name in self.wanted if name in self.handed.chosen]

    def marked(self) -> Marked:
        """Return the marks of all chapters as one, including points by hand."""
        marks = [self.marks[name] for name in self.wanted if name in self.marks]
        marked = Marked(self.label, "".join(mark.digest for mark in marks), tier=next((mark.tier for mark in marks), ""))
        marked.status = _together([mark.status for mark in marks])
        for chapter, verdicts in self.wanted.items():
            chapter_verdicts = self.marks[chapter].verdicts if chapter in self.marks else verdicts
            marked.verdicts += [self._by_hand(verdict) for verdict in chapter_verdicts]
        for mark in marks:
            marked.answers += mark.answers
            marked.variants |= mark.variants
            marked.traces |= mark.traces
        marked.notes = unique([*self.handed.notes, *(note for mark in marks for note in mark.notes)])
        marked.concerns = unique([*self.handed.concerns, *(said for mark in marks for said in mark.concerns)])
        marked.minutes_late = max((lateness.minutes for lateness in self.late.values()), default=0.0)
        return marked

    def _by_hand(self, verdict: Verdict) -> Verdict:
        points = self.by_hand.get(verdict.name)
        return verdict if points is None else replace(verdict, points=points, fault="")

    def points(self) -> float:
        """Return the points before deductions for lateness."""
        return self.marked().total()

    def chapter_total(self, chapter: str) -> float:
        """Return the points of a chapter after deductions."""
        verdicts = self.marks[chapter].verdicts if chapter in self.marks else self.wanted.get(chapter, ())
        points = sum(self._by_hand(verdict).points for verdict in verdicts)
        return round(points * (1 - self.late.get(chapter, Late()).percent_off / 100), 2)

    def total_by_hand(self) -> bool:
        """Whether the teacher wrote the total."""
        return "total" in self.by_hand

    def total(self) -> float | None:
        """Return the total; None while a question is open or the work is not marked."""
        if self.total_by_hand():
            return self.by_hand["total"]
        if self.status() in ("question", "not marked"):
            return None
        return round(sum(self.chapter_total(chapter) for chapter in self.wanted), 2)

    def comments(self) -> dict[str, str]:
        """Return the teacher's comments for the person, by column, without the teacher's private columns."""
        exercises = [verdict.name + ON_EXERCISE for verdicts in self.wanted.values() for verdict in verdicts]
        return {name: self.extra[name] for name in (COMMENT, *exercises) if self.extra.get(name)}

    def counts(self) -> bool:
        """Whether the mark is part of the class's average: it exists, with a submission or points by hand."""
        known = {"total", *(verdict.name for verdicts in self.wanted.values() for verdict in verdicts)}
        return bool(self.chapters() or known & set(self.by_hand)) and self.total() is not None

    def told_chapters(self) -> str:
        """Return the requested chapters as text."""
        return ", ".join(PurePosixPath(name).stem for name in self.wanted)

    def told_off(self) -> str:
        """Return the deductions for lateness as text; empty if there are none."""
        percent_by_chapter = {name: late.percent_off for name, late in self.late.items() if late.percent_off}
        if len(set(percent_by_chapter.values())) == 1 and len(percent_by_chapter) == len(self.wanted):
            return f"{number(next(iter(percent_by_chapter.values())))} %"
        return ", ".join(f"{number(off)} % of {PurePosixPath(name).stem}" for name, off in percent_by_chapter.items())

    def of(self) -> float:
        """Return the maximum number of points."""
        return sum(verdict.of for verdicts in self.wanted.values() for verdict in verdicts)

    def status(self) -> str:
        """Return the status."""
        complete = bool(self.marks) and all(name in self.marks for name in self.chapters())
        marked = self.marked() if complete else None
        if self.handed.entries and not self.chapters():
            marked = Marked(self.label, "", status="unreadable" if self._faulty() else "empty")
        late = any(lateness.minutes for lateness in self.late.values())
        opened, tier = bool(self.handed.open), self.tier
        return status_of(marked, opened=opened, handed_in=bool(self.handed.entries), late=late, tier=tier)

    def _faulty(self) -> bool:
        return any(entry.faults or any(piece.fault for piece in entry.pieces) for entry in self.handed.entries)

    def code(self) -> dict[str, str]:
        """Return the person's answers, by exercise."""
        return {name: text for piece in self.handed.chosen.values() for name, text in piece.known.code.items()}

    def time_from(self) -> str:
        """Return the source of the times from which lateness was computed."""
        return "; ".join(unique(lateness.when_from for lateness in self.late.values() if lateness.when_from))


def _together(statuses: Sequence[str]) -> str:
    """Return the most urgent status; empty only if all are."""
    for status in ("error", "unreadable"):
        if status in statuses:
            return status
    return "empty" if statuses and all(status == "empty" for status in statuses) else "graded"


def lateness_of(handed: PersonSubmission, chapters: Sequence[str], policy: Policy) -> dict[str, Late]:
    """Return the lateness of each chapter; contradictions between times are reported to the teacher."""
    lateness = {}
    for chapter in chapters:
        piece = handed.chosen.get(chapter)
        if piece is None:
            continue
        minutes = policy.minutes_late(handed.person, piece.when)
        if piece.when > now() + DAY_S:
            said = f"{piece.when_from} is {told_time(piece.when)}, which is yet to come: was that computer's clock wrong?"
            handed.concerns.append(f"{piece.where}: {said}")
        if piece.when_from == SEALED and not minutes and policy.minutes_late(handed.person, piece.inner) > 60:
            handed.concerns.append(f"{piece.where} was sealed in time, but the file is of {told_time(piece.inner)}")
        if piece.late_said and not minutes:
            handed.concerns.append(f"the platform says that {piece.where} was late; the file's time does not say how much")
            minutes = 1.0
        lateness[chapter] = Late(minutes, piece.when, piece.when_from, policy.percent_off(minutes))
    return lateness
