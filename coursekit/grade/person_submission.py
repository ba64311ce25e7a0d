"""One person's submission, and the file that counts for each chapter."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from .roster import Person
from .sanitizing import name_of_files
from .submission_parts import Entry, Piece, told_time
from .submissions import Submission


@dataclass
class PersonSubmission:
    """One person's submission."""

    person: Person
    label: str
    entries: list[Entry] = field(default_factory=list)
    chosen: dict[str, Piece] = field(default_factory=dict)
    """The file that counts, by chapter."""
    notes: list[str] = field(default_factory=list)
    """Messages for the student."""
    concerns: list[str] = field(default_factory=list)
    """Messages for the teacher only."""
    open: list[str] = field(default_factory=list)
    """Questions to answer before there is a mark."""

    @property
    def key(self) -> str:
        """The name of the person's files."""
        return name_of_files(self.person.identity, self.label)

    def pieces(self) -> list[Piece]:
        """Return every submitted notebook, the oldest first."""
        pieces = [piece for entry in self.entries for piece in entry.pieces]
        return sorted(pieces, key=lambda piece: (piece.when, piece.inner, piece.where))

    def bundles(self) -> list[Path]:
        """Return all submitted files made by `hand_in()`."""
        return [file for entry in self.entries for file in entry.bundles]

    def attempts(self) -> list[str]:
        """Return every submitted notebook with its time."""
        return [f"{piece.where}, {told_time(piece.when)}" for piece in self.pieces()]

    def submission(self, chapter: str) -> Submission:
        """Return the submission to mark for a chapter."""
        piece = self.chosen[chapter]
        assert piece.file is not None
        bundles = [piece.bundle] if piece.bundle else []
        return Submission(self.label, piece.file, {chapter: piece.file}, bundles)


def wanted_chapters(handed: Sequence[PersonSubmission]) -> tuple[list[str], dict[str, list[str]]]:
    """Return the chapters that most people handed in (else all), and the people with each of the others."""
    chapters: dict[str, list[str]] = {}
    for student in handed:
        for chapter in {piece.chapter for piece in student.pieces() if piece.chapter}:
            chapters.setdefault(chapter, []).append(student.label)
    some = sum(any(piece.chapter for piece in student.pieces()) for student in handed)
    most = sorted(name for name, people in chapters.items() if 2 * len(people) > some)
    if not most:
        return sorted(chapters), {}
    return most, {name: sorted(people) for name, people in sorted(chapters.items()) if name not in most}
