"""grades.csv: a row for each person, complete at every moment; the teacher's changes by hand are kept."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from coursekit.files import write_whole

from .record import COMMENT, Record
from .sanitizing import cell, number, shown
from .tables import COMMA, Form, read_table, write_table

_BEFORE = ("key", "student", "id", "email")
"""The key is first: the byte order mark that spreadsheets need then affects only the first heading."""
_AFTER = (
    "points", "percent_off", "total", "of", "status", "tier", "minutes_late", "time_from", "attempts", "notes", COMMENT,
)  # fmt: skip


@dataclass
class ByHand:
    """The teacher's changes in the table."""

    points: dict[str, dict[str, float]] = field(default_factory=dict)
    """By key and exercise, and by `total_of` for the sum of these chapters."""
    extra: dict[str, dict[str, str]] = field(default_factory=dict)
    """By key and column."""
    told: list[str] = field(default_factory=list)

    def points_of(self, key: str, chapters: Sequence[str]) -> dict[str, float]:
        """Return a person's points by hand, by exercise; `total` if the sum of exactly these chapters was written.

        >>> by_hand = ByHand({"ada": {"relay": 2.0, total_of(["02_topics"]): 9.0, total_of(["03_services"]): 5.0}})
        >>> by_hand.points_of("ada", ["02_topics"])
        {'relay': 2.0, 'total': 9.0}
        """
        points = self.points.get(key, {})
        own = total_of(chapters)
        return {
            ("total" if name == own else name): mark for name, mark in points.items() if name == own or not _is_total(name)
        }

    def move(self, before: str, now: str) -> None:
        """Move changes from one key to another, for work whose name was hidden before.

        >>> by_hand = ByHand({"participant 17": {"relay": 2.0}})
        >>> by_hand.move("participant 17", "ada")
        >>> by_hand.points
        {'ada': {'relay': 2.0}}
        """
        if points := self.points.pop(before, {}):
            self.points[now] = {**points, **self.points.get(now, {})}
        if extra := self.extra.pop(before, {}):
            self.extra[now] = {**extra, **self.extra.get(now, {})}


def total_of(chapters: Iterable[str]) -> str:
    """Return the name of the sum of these chapters among the points by hand: another run has another sum.

    >>> total_of(["03_services", "02_topics"])
    'total of 02_topics 03_services'
    """
    return " ".join(["total of", *sorted(chapters)])


def _is_total(name: str) -> bool:
    return name.startswith("total of ")


class MarksTable:
    """The table, and a snapshot of its last version beside the results."""

    def __init__(self, file: Path, folder: Path, form: Form = COMMA) -> None:
        self.file = file
        self._form = form
        self._snapshot = folder / "table.json"
        self._kept = folder / "by_hand.json"
        self.by_hand = ByHand()

    def notice(self) -> ByHand:
        """Return the changes by hand since the table was written, together with earlier ones.

        Raises:
            ValueError: when the table cannot be read.
        """
        self.by_hand = self._read_kept()
        if self.file.is_file() and (before := _json(self._snapshot)):
            for row in read_table(self.file).dicts():
                written = before.get(row.get("key", ""))
                if isinstance(written, dict):
                    self._compare(row, written)
        return self.by_hand

    def _compare(self, row: Mapping[str, str], written: Mapping[str, str]) -> None:
        key, who = row["key"], shown(row.get("student", ""))
        for column, text in row.items():
            was = written.get(column)
            if not column or text == was or column in _BEFORE:
                continue
            if was is None or column == COMMENT:
                self._note_extra(key, who, column, text)
            elif column == "total":
                self._note_points(key, who, column, text, was, written.get("chapters", ""))
            elif "." in column:
                self._note_points(key, who, column, text, was, column)
            elif not _same(text, was):
                self.by_hand.told.append(f"{who}: '{column}' is written again at each run: the change is not kept")

    def _note_extra(self, key: str, who: str, column: str, text: str) -> None:
        kept = self.by_hand.extra.setdefault(key, {})
        if text and kept.get(column) != text:
            self.by_hand.told.append(f"{who}: what you wrote under '{shown(column, 40)}' is kept")
        kept[column] = text

    def _note_points(self, key: str, who: str, column: str, text: str, was: str, name: str) -> None:
        kept = self.by_hand.points.setdefault(key, {})
        if not text:
            kept.pop(name, None)
            self.by_hand.told.append(f"{who}: {column} is the grader's again")
            return
        points = _points(text)
        if points is None:
            self.by_hand.told.append(f"{who}: {column} '{shown(text, 40)}' is not a number: ignored")
        elif points != _points(was):
            kept[name] = points
            self.by_hand.told.append(f"{who}: {column} is {number(points)} by hand (was {was or 'empty'})")

    def write(self, records: Sequence[Record]) -> None:
        """Write the complete table."""
        exercises = [verdict.name for verdicts in (records[0].wanted.values() if records else ()) for verdict in verdicts]
        extra = list(dict.fromkeys(name for record in records for name in record.extra if name not in (*_AFTER, *_BEFORE)))
        headings = [*_BEFORE, *exercises, *_AFTER, *extra]
        rows = [
            {**_row(record, self._form), **{name: cell(text) for name, text in record.extra.items()}} for record in records
        ]
        write_table(self.file, headings, rows, self._form)
        before = _json(self._snapshot)
        chapters = {"chapters": total_of(records[0].wanted) if records else ""}
        before.update({row["key"]: {name: row.get(name, "") for name in headings} | chapters for row in rows})
        write_whole(self._snapshot, json.dumps(before, indent=1).encode(), parents=True)
        kept = {"points": self.by_hand.points, "extra": self.by_hand.extra}
        write_whole(self._kept, json.dumps(kept, indent=1).encode(), parents=True)

    def _read_kept(self) -> ByHand:
        said = _json(self._kept)
        return ByHand(said.get("points", {}), said.get("extra", {}))


def _row(record: Record, form: Form) -> dict[str, str]:
    marked, total = record.marked(), record.total()
    by_hand = [f"{name}: {number(points)} by hand" for name, points in record.by_hand.items()]
    asked = [f"question: {text}" for text in record.handed.open]
    known = record.handed.person.row >= 0
    off = max((late.percent_off for late in record.late.values()), default=0.0)
    open_ = record.status() in ("question", "not marked")
    points = {v.name: form.number(v.points) if not open_ or v.name in record.by_hand else "" for v in marked.verdicts}
    return {
        "key": record.key,
        "student": cell(record.label),
        "id": cell(record.handed.person.id) if known else "",
        "email": cell(record.handed.person.email),
        **points,
        "points": "" if open_ else form.number(marked.total()),
        "percent_off": form.number(off),
        "total": "" if total is None else form.number(total),
        "of": form.number(record.of()),
        "status": record.status(),
        "tier": marked.tier,
        "minutes_late": form.number(marked.minutes_late),
        "time_from": record.time_from(),
        "attempts": cell(" | ".join(record.handed.attempts()[-20:])),
        "notes": cell("; ".join([*asked, *by_hand, *marked.concerns, *marked.notes])),
    }


def _same(text: str, was: str) -> bool:
    """Whether a cell still has its written content, however a spreadsheet saved it: `1,5` for 1.5, `?` for a letter."""
    points = _points(text)
    return _plain(text) == _plain(was) or (points is not None and points == _points(was))


def _plain(text: str) -> str:
    """Return the part of a text preserved by every encoding: Windows and macOS save other letters differently."""
    return "".join(letter for letter in text.strip("' ") if letter.isascii() and letter != "?")


def _points(text: str) -> float | None:
    """Parse a number, also with a decimal comma: `1,5`."""
    try:
        points = float(text.strip("' ").replace(",", "."))
    except ValueError:
        return None
    return points if abs(points) < 1e6 else None


def _json(file: Path) -> dict[str, Any]:
    try:
        content = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return content if isinstance(content, dict) else {}
