"""A teacher's marks by hand: entered into the table and the records, and kept in later runs."""

from __future__ import annotations

import math
from collections.abc import Sequence

from coursekit.grade.batch import Class
from coursekit.grade.outcome import Outcome
from coursekit.grade.overview import overview
from coursekit.grade.record import COMMENT, ON_EXERCISE, Record
from coursekit.grade.report import said_of, write_reports
from coursekit.grade.sanitizing import number

LONGEST = 5000
"""The maximum length of a comment [characters]."""


class Marks:
    """The class during marking by hand."""

    def __init__(self, group: Class, outcome: Outcome) -> None:
        self._group, self._outcome = group, outcome
        self.folder = group.kept
        self.records = {record.key: record for record in group.shown(outcome.records)}

    def exercises(self, key: str) -> list[str]:
        """Return the names of a person's exercises."""
        return [verdict.name for verdicts in self.records[key].wanted.values() for verdict in verdicts]

    def points(self, key: str, exercise: str, text: str) -> None:
        """Set points by hand, or restore the grader's with an empty text.

        Raises:
            ValueError: when it is no number; LookupError: when there is no such person or exercise.
        """
        record = self._record(key, exercise)
        kept = self._group.table.by_hand.points.setdefault(key, {})
        if not text.strip():
            for points in (kept, record.by_hand):
                points.pop(exercise, None)
        else:
            kept[exercise] = record.by_hand[exercise] = _points(text)
        self._write(record)

    def comment(self, key: str, exercise: str, text: str) -> None:
        """Comment on an exercise, or on the whole work if it is empty."""
        record = self._record(key, exercise)
        if len(text) > LONGEST:
            raise ValueError(f"a comment has {LONGEST} letters at the most")
        column = exercise + ON_EXERCISE if exercise else COMMENT
        self._group.table.by_hand.extra.setdefault(key, {})[column] = text
        record.extra[column] = text
        self._write(record)

    def remark(self, key: str, exercise: str) -> str:
        """Return a remark if more than the maximum points were given."""
        record = self.records[key]
        of = next(
            (verdict.of for verdicts in record.wanted.values() for verdict in verdicts if verdict.name == exercise), 0.0
        )
        given = record.by_hand.get(exercise, 0.0)
        return f"Saved: {number(given)} of {number(of)}, a bonus" if given > of else ""

    def shown(self, key: str, exercise: str) -> dict[str, str]:
        """Return a person's current total and status, and the verdict on an exercise as HTML."""
        record = self.records[key]
        total = record.total()
        told = {"total": "no mark yet" if total is None else number(total), "status": record.status().capitalize()}
        verdicts = [verdict for verdict in record.marked().verdicts if verdict.name == exercise]
        return told | {"verdict": said_of(verdicts[0], record) if verdicts else ""}

    def class_page(self) -> str:
        """Return the current page of the class."""
        return overview(list(self.records.values()), self._outcome)

    def finish(self) -> None:
        """Write all pages and tables again."""
        self._group.write(self._outcome)

    def order(self) -> Sequence[str]:
        """Return all keys in the table's order, including people without files: points may be given for other work."""
        return list(self.records)

    def _record(self, key: str, exercise: str) -> Record:
        if key not in self.records or (exercise and exercise not in self.exercises(key)):
            raise LookupError(f"there is no {exercise or 'person'} of that name")
        return self.records[key]

    def _write(self, record: Record) -> None:
        self._group.table.write(list(self.records.values()))
        write_reports(self._group.kept, [record])


def _points(text: str) -> float:
    try:
        points = float(text.strip().replace(",", "."))
    except ValueError:
        points = math.nan
    if not 0 <= points <= 1000:
        raise ValueError("points are a number from 0 on, such as 1.5")
    return points
