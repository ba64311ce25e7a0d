"""The gradebook of all chapters: a row for each person, a column for each chapter ever marked."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path, PurePosixPath
from typing import Any

from .record import Record
from .results import Results
from .sanitizing import cell
from .tables import COMMA, Form, write_table


def write_gradebook(
    file: Path, shown: Sequence[Record], records: Sequence[Record], results: Results, form: Form = COMMA
) -> None:
    """Write the gradebook: the chapters of this run, and the stored results of earlier ones.

    A person without a mark in this run has no total either.
    """
    by_name = {record.label: record for record in records}
    earlier = {record.key: _earlier(record, results) for record in records}
    columns = sorted(
        {name for record in records for name in record.wanted} | {name for kept in earlier.values() for name in kept}
    )
    hidden = len(records) == len(shown) and [record.key for record in shown] != [record.key for record in records]
    rows = []
    for record in shown:
        points = {} if hidden else earlier[by_name[record.label].key]
        points |= _of_run(record)
        person = record.handed.person
        rows.append([
            cell(record.label), cell(person.id) if person.row >= 0 else "", cell(person.email),
            *(form.number(points[name]) if name in points else "" for name in columns),
            "" if record.total() is None else form.number(round(sum(points.values()), 2)), record.key,
        ])  # fmt: skip
    headings = ["student", "id", "email", *(PurePosixPath(name).stem for name in columns), "total", "key"]
    write_table(file, headings, rows, form)


def _of_run(record: Record) -> dict[str, float]:
    """Return the points of this run's chapters; a total written by hand is used if there is only one chapter."""
    total = record.total()
    if total is None:
        return {}
    if record.total_by_hand() and len(record.wanted) == 1:
        return dict.fromkeys(record.wanted, total)
    by_hand = {name for name, asked in record.wanted.items() if any(verdict.name in record.by_hand for verdict in asked)}
    return {name: record.chapter_total(name) for name in record.wanted if name in record.chapters() or name in by_hand}


def _earlier(record: Record, results: Results) -> dict[str, float]:
    """Return the points of the chapters outside this run."""
    earlier = {}
    for name, kept in results.chapters(record.key).items():
        if name not in record.wanted:
            earlier[name] = _points(kept, record)
    return earlier


def _points(kept: dict[str, Any], record: Record) -> float:
    verdicts = kept["marked"]["verdicts"]
    points = sum(record.by_hand.get(verdict["name"], verdict["points"]) for verdict in verdicts)
    off = kept.get("facts", {}).get("percent_off", 0.0)
    return round(float(points) * (1 - float(off) / 100), 2)
