"""Anonymous marking: codes replace names on pages and in tables; a separate file maps codes to names."""

from __future__ import annotations

import csv
import hashlib
import hmac
import io
import re
from collections.abc import Mapping, Sequence
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from coursekit.files import write_whole

from .mark import Marked
from .record import Record
from .roster import Person
from .sanitizing import cell
from .submission_parts import Entry, Piece
from .tables import COMMA, Form
from .teacher_secrets import own_key
from .verdict import Verdict

_ASKED = re.compile(r"whose '(.+?)' is")


class Anonymity:
    """Gives a person the same code in every run of this account."""

    def __init__(self, names: Path, form: Form = COMMA) -> None:
        self.names = names
        self._form = form
        self._key = own_key("codes.key")

    def code(self, person: Person) -> str:
        """Return the code of a person."""
        digest = hmac.new(self._key, person.identity.encode("utf-8", "surrogatepass"), hashlib.sha256).hexdigest()
        return f"P-{digest[:8].upper()}"

    def key(self, record: Record) -> str:
        """Return the name of a person's files while names are hidden."""
        return self._hidden(record).key

    def of(self, records: Sequence[Record]) -> list[Record]:
        """Return the records with codes in place of names, sorted by code; the mapping is written to a file beside them."""
        others = self._everybody(records)
        hidden = [self._hidden(record, others) for record in records]
        buffer = io.StringIO()
        table = csv.writer(buffer, delimiter=self._form.separator)
        table.writerow(["code", "name", "id", "email"])
        for record in records:
            person = record.handed.person
            table.writerow([self.code(person), cell(record.label), cell(person.id), cell(person.email)])
        write_whole(self.names, buffer.getvalue().encode("utf-8-sig"), 0o600, parents=True)
        return sorted(hidden, key=lambda record: record.label)

    def _everybody(self, records: Sequence[Record]) -> dict[str, str]:
        """Return the replacements for others' names, and for the names of their files."""
        entries = [entry.name for record in records for entry in record.handed.entries]
        entries += [name for record in records for name in _ASKED.findall(" ".join(record.handed.open))]
        labels = {record.label: self.code(record.handed.person) for record in records}
        return dict.fromkeys(filter(None, entries), "a hand-in") | labels

    def _hidden(self, record: Record, others: Mapping[str, str] | None = None) -> Record:
        code, handed = self.code(record.handed.person), record.handed
        said = _Hiding(record, code)
        entries = [
            Entry(code, [_piece(said, code, piece) for piece in entry.pieces], [said(fault) for fault in entry.faults])
            for entry in handed.entries
        ]
        chosen = {name: _piece(said, code, piece) for name, piece in handed.chosen.items()}
        kinds = ("notes", "concerns", "open")
        texts = {kind: [said(_without(piece, others or {})) for piece in getattr(handed, kind)] for kind in kinds}
        masked = replace(handed, person=Person(code), label=code, entries=entries, chosen=chosen, **texts)
        return replace(record, handed=masked, marks={name: _marked(said, code, mark) for name, mark in record.marks.items()})


def _without(text: str, names: Mapping[str, str]) -> str:
    """Replace names in a text; the longest first, because they may contain shorter ones."""
    for name in sorted(names, key=len, reverse=True):
        text = text.replace(name, names[name])
    return text


class _Hiding:
    """Removes a person's names from texts."""

    def __init__(self, record: Record, code: str) -> None:
        person, handed = record.handed.person, record.handed
        entries = [entry.name for entry in handed.entries]
        stems = [re.sub(r"\.(ipynb|zip)$", "", name, flags=re.I) for name in entries if not name[:1].isdigit()]
        words = [*person.names(), *person.keys(), person.family, person.given, handed.label, *stems]
        known = sorted({word for word in words if len(word) > 2}, key=len, reverse=True)
        self._names = re.compile("|".join(re.escape(name) for name in known) or "(?!)", re.I)
        self._code = code

    def __call__(self, text: str) -> str:
        return self._names.sub(self._code, text)


def _piece(said: _Hiding, code: str, piece: Piece) -> Piece:
    own = {name: said(text) for name, text in piece.known.code.items()}
    return replace(piece, where=said(piece.where), entry=code, known=replace(piece.known, code=own))


def _verdict(said: _Hiding, verdict: Verdict) -> Verdict:
    values: dict[str, Any] = asdict(verdict)
    hidden: dict[str, Any] = {name: said(value) if isinstance(value, str) else value for name, value in values.items()}
    return Verdict(**hidden)


def _marked(said: _Hiding, code: str, marked: Marked) -> Marked:
    verdicts = [_verdict(said, verdict) for verdict in marked.verdicts]
    notes, concerns = [said(note) for note in marked.notes], [said(note) for note in marked.concerns]
    return replace(marked, student=code, verdicts=verdicts, notes=notes, concerns=concerns)
