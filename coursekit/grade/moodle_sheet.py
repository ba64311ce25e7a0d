"""Moodle's grading worksheet: its headings are in the site's language, so its columns are also recognised by content."""

from __future__ import annotations

import re

from .tables import Table

_PARTICIPANT = re.compile(r"(partic|partec|teilnehm|deelnem|delt|osallist|uczest)\D{0,20}?\s*(\d+)", re.I)
"""`Participant 101`, `Participante101`, `Teilnehmer/in101`."""
_MARK = {"grade", "calificación", "note", "bewertung", "nota", "valutazione", "qualificació", "beoordeling", "cijfer"}
_MAXIMUM = {"maximum grade", "calificación máxima", "note maximale", "höchste bewertung", "bestwertung", "nota máxima",
            "valutazione massima", "qualificació màxima", "maximumcijfer"}  # fmt: skip
_COMMENTS = {"feedback comments", "feedback als kommentar", "feedback-kommentare", "commentaires"}
_COMMENTS_BEGIN = ("comentarios de retro", "comentários de feedback", "commentaires de", "commenti", "comentaris de retro")


def participants(table: Table) -> int | None:
    """Return the column of Moodle's participant numbers, regardless of its heading; None if there is none.

    >>> participants(Table(["Identificador", "Nombre completo"], [["Participante501", "Ann"], ["Participante502", "Ben"]]))
    0
    """
    for place in range(len(table.headings)):
        matches = [_PARTICIPANT.fullmatch(row[place]) for row in table.rows if len(row) > place]
        numbers = [match[2] for match in matches if match]
        if numbers and len(numbers) == len(table.rows) == len(set(numbers)):
            return place
    return None


def maximum_column(table: Table) -> int | None:
    """Return the column of the assignment's maximum."""
    return _named(table, _MAXIMUM)


def mark_column(table: Table) -> int | None:
    """Return the column from which Moodle reads marks: by its heading, else the one before the maximum."""
    column, maximum = _named(table, _MARK), maximum_column(table)
    return maximum - 1 if column is None and maximum else column


def comment_column(table: Table) -> int | None:
    """Return the column from which Moodle reads comments."""
    known = _known(table)
    column = _named(table, _COMMENTS)
    return (
        column
        if column is not None
        else next((known.index(heading) for heading in known if heading.startswith(_COMMENTS_BEGIN)), None)
    )


def _named(table: Table, words: set[str]) -> int | None:
    known = _known(table)
    return next((place for place, heading in enumerate(known) if heading in words), None)


def _known(table: Table) -> list[str]:
    return [heading.strip().casefold() for heading in table.headings]
