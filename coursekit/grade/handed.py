"""One person's submission, and the file that counts for each chapter."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from .harmless import name_of_files
from .pieces import Entry, Piece, told_time
from .roster import Person
from .submissions import Submission


@dataclass
class Handed:
    """One person's submission."""

    person: Person
    label: str
    entries: list[Entry] = field(default_factory=list)
    chosen: dict[str, Piece] = field(default_factory=dict)
    """The file that counts, by chapter."""
    notes: list[str] = field(default_factory=list)
    """The student sees these."""
    concerns: list[str] = field(default_factory=list)
    """For the teacher's eye only."""
    open: list[str] = field(default_factory=list)
    """Questions that have to be answered before there is a mark."""

    @property
    def key(self) -> str:
        """The name of their files."""
        return name_of_files(self.person.identity, self.label)

    def pieces(self) -> list[Piece]:
        """Every notebook that they handed in, the oldest first."""
        found = [piece for entry in self.entries for piece in entry.pieces]
        return sorted(found, key=lambda one: (one.when, one.inner, one.where))

    def bundles(self) -> list[Path]:
        """Everything of theirs that `hand_in()` made."""
        return [file for entry in self.entries for file in entry.bundles]

    def attempts(self) -> list[str]:
        """Every notebook that they handed in, and when."""
        return [f"{one.where}, {told_time(one.when)}" for one in self.pieces()]

    def submission(self, chapter: str) -> Submission:
        """The file that is marked for a chapter."""
        piece = self.chosen[chapter]
        assert piece.file is not None
        bundles = [piece.bundle] if piece.bundle else []
        return Submission(self.label, piece.file, {chapter: piece.file}, bundles)


def wanted_chapters(handed: Sequence[Handed]) -> tuple[list[str], dict[str, list[str]]]:
    """The chapters that most people handed in, and who handed in which others; all where none is most people's."""
    chapters: dict[str, list[str]] = {}
    for one in handed:
        for chapter in {piece.chapter for piece in one.pieces() if piece.chapter}:
            chapters.setdefault(chapter, []).append(one.label)
    some = sum(any(piece.chapter for piece in one.pieces()) for one in handed)
    most = sorted(name for name, people in chapters.items() if 2 * len(people) > some)
    if not most:
        return sorted(chapters), {}
    return most, {name: sorted(people) for name, people in sorted(chapters.items()) if name not in most}
