"""Grade a class: collect the work, mark unmarked work in parallel, and write the table, pages and gradebook."""

from __future__ import annotations

import contextlib
import glob
import json
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, as_completed
from dataclasses import replace
from pathlib import Path, PurePosixPath
from typing import Any

from . import sandbox
from .anonymity import Anonymity
from .bundle import note_copies
from .collector import Collection, Collector
from .exercise import Exercise, exercises_in
from .gradebook import write_gradebook
from .lateness import Policy
from .mark import Marked, mark
from .marks_table import MarksTable
from .outcome import Outcome
from .overview import write_overview
from .person_submission import PersonSubmission, wanted_chapters
from .questions import NAME as QUESTIONS
from .questions import read_answers, write_questions
from .record import Record, lateness_of
from .reference import Reference, expect_sound
from .report import write_reports
from .results import Results, key_of
from .roster import Roster
from .sandbox import Limits
from .similar import write_similar
from .statistics import write_statistics
from .tables import COMMA, Form, read_table
from .variants import Variants
from .verdict import Verdict
from .workers import Workers

Tell = Callable[[int, int, str], None]


class Class:
    """A folder or zip of submissions, and the place of its results."""

    def __init__(
        self,
        place: Path,
        out: Path,
        notebooks: Path,
        *,
        policy: Policy | None = None,
        roster: Roster | None = None,
        variants: Variants | None = None,
        personal: bool = False,
        chapters: Sequence[str] = (),
        anonymous: bool = False,
        form: Form | None = None,
        workers: Workers | None = None,
    ) -> None:
        self.place = place
        self.out = out
        self.kept = out.with_suffix("")
        self.policy = policy or Policy()
        self.variants = variants
        self.personal = personal
        """Whether the copies have individual values."""
        self.roster = roster or (variants.roster if variants else None)
        self.sources = _sources(notebooks)
        self.chapters = list(chapters)
        self.limits = Limits()
        self._marker = workers.mark if workers else mark
        self._tier = workers.tier if workers else sandbox.tier()
        self.results = Results(self.kept / "results")
        self.form = form or _form_of(out, self.roster)
        self.table = MarksTable(out, self.kept / "results", self.form)
        self.dice = variants.dice() if variants else self.results.dice()
        self._codes = Anonymity(out.with_name(f"{out.stem}.names.csv"), self.form)
        self.anonymity = self._codes if anonymous else None

    @contextlib.contextmanager
    def graded(
        self, jobs: int, tell: Tell, again: Sequence[str] | None = None, say: Callable[[str], None] = lambda line: None
    ) -> Iterator[Outcome]:
        """Grade ungraded work, or that of the students in `again` (everybody for an empty list), and write everything.

        The submissions stay unpacked until the context ends.

        Raises:
            GraderBroken: when the reference solutions do not get all points; no student is marked then.
            ValueError: when a table of the teacher cannot be read, or a name is unknown.
        """
        with tempfile.TemporaryDirectory(prefix="collected-") as scratch:
            by_hand = self.table.notice()
            collection = self._collect(Path(scratch))
            chapters, others = self._wanted(collection)
            wanted = {name: _unmarked(exercises_in(self.sources[name])) for name in chapters}
            records = [self._record(handed, wanted) for handed in collection.handed]
            if again is not None:
                self.results.forget(_asked(records, again), chapters)
            outcome = Outcome(records, collection)
            outcome.told += [*self.policy.told, *collection.told, *by_hand.told]
            outcome.told += [*_told_others(others), *_told_bonus(records)]
            try:
                for name in chapters if any(record.chapters() for record in records) else ():
                    marker = _announced(self._marker, name, say)
                    said = expect_sound(self._reference(name, Path(scratch)), self.results, marker)
                    outcome.told += [said] if said else []
                self._mark(records, jobs, tell)
            except KeyboardInterrupt:
                outcome.interrupted = True
            self.write(outcome)
            outcome.told += [*_told_faults(records), *self.results.told]
            outcome.told += self.results.told_changes([record.key for record in records])
            yield outcome

    def _reference(self, chapter: str, scratch: Path) -> Reference:
        source = self.sources[chapter]
        return Reference(chapter, source, exercises_in(source), scratch, self.limits, self.dice)

    def _collect(self, scratch: Path) -> Collection:
        asked = self.out.with_name(QUESTIONS)
        answers = read_answers(asked)
        marks = self.variants.copy_marks() if self.variants else {}
        collector = Collector(
            self.sources, scratch, roster=self.roster, copies=marks, policy=self.policy, answers=answers
        )
        collection = collector.collect(self.place, leave=self._written())
        write_questions(asked, collection.questions, answers, self.form)
        return collection

    def _written(self) -> list[Path]:
        """Return the files of earlier runs, which may be beside the submissions."""
        beside = self.out.parent.glob(f"{glob.escape(self.out.stem)}.*")
        return [self.kept, self.out, self.out.with_name(QUESTIONS), *beside]

    def _wanted(self, collection: Collection) -> tuple[list[str], dict[str, list[str]]]:
        if self.chapters:
            return self.chapters, {}
        chapters, others = wanted_chapters(collection.handed)
        return chapters or sorted(self.sources), others

    def _record(self, handed: PersonSubmission, wanted: Mapping[str, Sequence[Verdict]]) -> Record:
        record = Record(handed, wanted, tier=self._tier)
        for chapter in [name for name in handed.chosen if name not in wanted]:
            handed.concerns.append(f"{chapter} was handed in too; it is not marked here")
        record.late = lateness_of(handed, list(wanted), self.policy)
        before, now = record.key, self._codes.key(record)
        if self.anonymity is None:
            before, now = now, before
        self.table.by_hand.move(before, now)
        record.by_hand = self.table.by_hand.points_of(now, list(wanted))
        record.extra = dict(self.table.by_hand.extra.get(now, {}))
        return record

    def _mark(self, records: Sequence[Record], jobs: int, tell: Tell) -> None:
        """Mark the work without a valid stored result; the table is complete after each submission."""
        waiting: dict[Future[Marked], tuple[Record, str, dict[str, Any]]] = {}
        pool = ThreadPoolExecutor(max_workers=max(1, jobs))
        try:
            for record in records:
                for chapter in record.chapters():
                    task = self._task(record, chapter)
                    depends = key_of(task[0].digest(), task[1][chapter], task[2], self._tier, self.dice)
                    kept = self.results.read(record.key, chapter, depends)
                    if kept is not None:
                        record.marks[chapter] = replace(kept, student=record.label)
                    else:
                        waiting[pool.submit(self._marker, *task, self.limits, self.dice)] = (record, chapter, depends)
            for number, future in enumerate(as_completed(waiting), 1):
                self._take(future, *waiting[future])
                self.table.write(self.shown(records))
                tell(number, len(waiting), self.shown([waiting[future][0]])[0].label)
        except KeyboardInterrupt:
            pool.shutdown(wait=False, cancel_futures=True)
            for future, facts in waiting.items():
                if future.done() and not future.cancelled() and facts[1] not in facts[0].marks:
                    self._take(future, *facts)
            raise
        pool.shutdown()

    def _task(self, record: Record, chapter: str) -> tuple[Any, dict[str, Any], dict[str, Exercise]]:
        sources = {chapter: self.sources[chapter]}
        if self.variants and self.personal:
            sources = self.variants.copies(record.label, sources)
        return record.handed.submission(chapter), sources, exercises_in(*sources.values())

    def _take(self, future: Future[Marked], record: Record, chapter: str, depends: Mapping[str, Any]) -> None:
        try:
            marked = future.result()
        except Exception as error:  # mark() promises not to raise; other students' marks do not depend on it
            marked = Marked(record.label, "", status="error", notes=[f"it could not be marked: {error}"])
            marked.verdicts = list(record.wanted[chapter])
        record.marks[chapter] = marked
        if marked.status != "error" and not any(verdict.fault for verdict in marked.verdicts):
            self.results.write(record.key, chapter, depends, marked)

    def write(self, outcome: Outcome) -> None:
        """Write all results."""
        records = outcome.records
        note_copies({record.label: (record.handed.concerns, record.handed.bundles()) for record in records})
        for record in records:
            for chapter, late in record.late.items():
                self.results.note(record.key, chapter, {"percent_off": late.percent_off})
        shown = self.shown(records)
        self.table.write(shown)
        self.kept.mkdir(parents=True, exist_ok=True)
        marks = [record.marked() for record in shown if record.counts()]
        write_reports(self.kept, shown)
        write_similar(self.kept / "similar.csv", marks, self.form)
        write_statistics(self.kept, shown, outcome.statuses())
        write_overview(self.kept, shown, outcome)
        write_gradebook(self.kept / "gradebook.csv", shown, records, self.results, self.form)

    def shown(self, records: Sequence[Record]) -> list[Record]:
        """Return the records for display: with codes in place of names if marking is anonymous."""
        return list(records) if self.anonymity is None else self.anonymity.of(records)


def _unmarked(exercises: Mapping[str, Exercise]) -> list[Verdict]:
    return [
        Verdict(exercise.name, exercise.title, 0, exercise.points, "your work", "nothing was handed in")
        for exercise in exercises.values()
    ]


def _told_others(others: Mapping[str, Sequence[str]]) -> list[str]:
    """Report chapters that only a few students handed in; they get no column."""
    return [
        f"{name} was handed in only by {', '.join(people[:5])}{' and others' if len(people) > 5 else ''}: it is not marked. "
        f"To mark it: --chapters {name.partition('_')[0]}"
        for name, people in others.items()
    ]


def _told_bonus(records: Sequence[Record]) -> list[str]:
    """Report points by hand above an exercise's maximum: a bonus, or a typo."""
    return [
        f"{record.label}: {verdict.name} is {verdict.points:g} by hand, and has {verdict.of:g} points. A bonus?"
        for record in records
        for verdict in record.marked().verdicts
        if verdict.name in record.by_hand and verdict.points > verdict.of
    ]


def _told_faults(records: Sequence[Record]) -> list[str]:
    """Report checks that failed by themselves, and the students left without a mark."""
    people_by_fault: dict[tuple[str, str], list[str]] = {}
    for record in records:
        for verdict in record.marked().verdicts:
            if verdict.fault:
                people_by_fault.setdefault((verdict.name, verdict.fault), []).append(record.label)
    return [
        f"The check of {name} has a fault: {fault}. No mark yet: {', '.join(people[:5])}"
        f"{' and others' if len(people) > 5 else ''}. Mend it and run this again, or give the points by hand."
        for (name, fault), people in people_by_fault.items()
    ]


def _asked(records: Sequence[Record], again: Sequence[str]) -> list[str]:
    """Return the keys of the students to mark again."""
    if not again:
        return [record.key for record in records]
    keys = []
    for name in again:
        fitting = [r.key for r in records if name in (r.key, r.label, r.handed.person.id, r.handed.person.email)]
        if not fitting:
            known = ", ".join(record.label for record in records[:10])
            raise ValueError(f"--again: no student '{name}'. There are: {known}{', ...' if len(records) > 10 else ''}")
        keys += fitting
    return keys


def _announced(mark: Callable[..., Marked], chapter: str, say: Callable[[str], None]) -> Callable[..., Marked]:
    """Wrap marking to announce that the course's own solutions are marked first, since this takes unexpected time."""

    def first(*facts: Any) -> Marked:
        say(f"Marking the course's own solutions first: {PurePosixPath(chapter).stem}.")
        return mark(*facts)

    return first


def _form_of(out: Path, roster: Roster | None) -> Form:
    """Return the CSV format for the teacher's spreadsheet: that of the existing marks, else that of the roster."""
    if out.is_file() and out.stat().st_size:
        return read_table(out).form
    return roster.form if roster is not None else COMMA


def _sources(notebooks: Path) -> dict[str, Any]:
    sources = {}
    for file in sorted(notebooks.glob("*.ipynb")):
        sources[file.name] = json.loads(file.read_text(encoding="utf-8"))
    if not sources:
        raise SystemExit(f"There are no notebooks in {notebooks}: say with --notebooks where the course's are.")
    return sources
