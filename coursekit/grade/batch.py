"""Grades a class: many submissions side by side, resumed where it stopped, into a table and a report each."""

from __future__ import annotations

import csv
import json
import sys
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path
from typing import Any

from .exercise import Exercise, exercises_in
from .mark import Marked, mark
from .overview import write_overview
from .report import write_reports
from .sandbox import Limits
from .similar import write_similar
from .statistics import write_statistics
from .submissions import Submission, find_submissions
from .variants import Variants, values_of


class Class:
    """A folder of submissions, and where its results are kept."""

    def __init__(
        self, folder: Path, out: Path, notebooks: Path, *, due: float | None = None, variants: Variants | None = None
    ) -> None:
        self.folder = folder
        self.out = out
        self.due = due
        self.variants = variants
        self.kept = out.with_suffix("")
        self.sources = _sources(notebooks)
        self.limits = Limits()

    def grade(self, jobs: int, tell: Callable[[int, int, str], None]) -> list[Marked]:
        """Grade what is not graded yet, and write everything; the results in the order of the students."""
        submissions = find_submissions(self.folder)
        self.kept.mkdir(parents=True, exist_ok=True)
        wanted, exercises = self._wanted(submissions)
        done: dict[str, Marked] = {}
        with ThreadPoolExecutor(max_workers=max(1, jobs)) as pool:
            waiting = {pool.submit(self._one, one, wanted, exercises): one for one in submissions}
            for number, future in enumerate(as_completed(waiting), 1):
                marked = future.result()
                done[marked.student] = marked
                tell(number, len(submissions), marked.student)
        marks = [done[one.student] for one in submissions]
        self._write(marks, exercises)
        return marks

    def _wanted(self, submissions: Sequence[Submission]) -> tuple[dict[str, Any], dict[str, Exercise]]:
        """The notebooks that at least one student handed in, and their exercises."""
        names = {name for one in submissions for name in one.names()}
        chosen = {name: text for name, text in self.sources.items() if _meant(name, names)} or self.sources
        return chosen, exercises_in(*chosen.values())

    def _one(self, submission: Submission, sources: Mapping[str, Any], exercises: Mapping[str, Exercise]) -> Marked:
        file = self.kept / f"{submission.student}.json"
        student = self.variants.roster.find(submission.student) if self.variants else ""
        if self.variants and student:
            sources = self.variants.copies(student, sources)
        marked = _kept(file, submission)
        known = marked and ({one.name for one in marked.verdicts}, marked.variants)
        if marked is None or known != (set(exercises), values_of(sources.values())):
            marked = mark(submission, sources, exercises, self.limits)
            if self.variants and not student:
                marked.notes.append("nobody in the list of names is called so; judged by the course's own values")
        late = 0.0 if self.due is None else max(0.0, (submission.newest() - self.due) / 60)
        marked.minutes_late = round(late, 1)
        file.write_text(json.dumps(marked.as_json()), encoding="utf-8")
        return marked

    def _write(self, marks: Sequence[Marked], exercises: Mapping[str, Exercise]) -> None:
        _note_copies(marks)
        write_table(self.out, marks, list(exercises))
        write_reports(self.kept, marks)
        write_similar(self.kept / "similar.csv", marks)
        write_statistics(self.kept, marks)
        write_overview(self.kept, marks)


def _note_copies(marks: Sequence[Marked]) -> None:
    """Tell who handed in the same pictures or the same log as somebody else; that is found anew each time."""
    owners: dict[str, list[str]] = {}
    for one in marks:
        for digest in one.traces:
            owners.setdefault(digest, []).append(one.student)
    for one in marks:
        shared: dict[str, list[str]] = {}
        for digest, what in one.traces.items():
            for other in owners[digest]:
                if other != one.student:
                    shared.setdefault(other, []).append(what)
        one.concerns += [f"the same as in {other}'s: {', '.join(what[:3])}" for other, what in shared.items()]


def _meant(name: str, handed_in: Iterable[str]) -> bool:
    """Whether one of the files is that notebook, perhaps with more in its name."""
    return any(one.startswith(Path(name).stem) for one in handed_in)


def _sources(notebooks: Path) -> dict[str, Any]:
    found = {}
    for file in sorted(notebooks.glob("*.ipynb")):
        found[file.name] = json.loads(file.read_text(encoding="utf-8"))
    if not found:
        raise SystemExit(f"There are no notebooks in {notebooks}: say with --notebooks where the course's are.")
    return found


def _kept(file: Path, submission: Submission) -> Marked | None:
    """The result of an earlier run, if the submission is still the same."""
    try:
        found = Marked.of_json(json.loads(file.read_text(encoding="utf-8")))
    except (OSError, ValueError, TypeError, KeyError):
        return None
    return found if found.digest == submission.digest() and found.status != "error" else None


def write_table(file: Path, marks: Sequence[Marked], exercises: Sequence[str]) -> None:
    """A CSV table: a row per student, a column per question."""
    with open(file, "w", newline="", encoding="utf-8") as out:
        table = csv.writer(out)
        table.writerow(["student", *exercises, "total", "status", "tier", "minutes_late", "notes"])
        for one in marks:
            points = {verdict.name: verdict.points for verdict in one.verdicts}
            row = [_harmless(one.student), *(f"{points.get(name, 0):g}" for name in exercises)]
            notes = _harmless("; ".join([*one.concerns, *one.notes]))
            table.writerow([*row, f"{one.total():g}", one.status, one.tier, f"{one.minutes_late:g}", notes])


def _harmless(text: str) -> str:
    """No cell begins like a formula: spreadsheets would run it."""
    return f"'{text}" if text[:1] in ("=", "+", "-", "@", "\t") else text


class Bar:
    """A progress bar on a terminal; a line now and then elsewhere."""

    def __init__(self) -> None:
        self._started = time.monotonic()

    def __call__(self, done: int, of: int, student: str) -> None:
        """Show how far it is."""
        left = (time.monotonic() - self._started) / done * (of - done)
        if sys.stderr.isatty():
            full = round(30 * done / of)
            line = f"\r{'█' * full}{'·' * (30 - full)} {done} of {of}, about {left:.0f} s left  {student[:20]:<20}"
            print(line, end="\n" if done == of else "", file=sys.stderr, flush=True)
        elif done == of or done % 10 == 0:
            print(f"{done} of {of} graded, about {left:.0f} s left", file=sys.stderr, flush=True)
