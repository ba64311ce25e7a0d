"""The students of one folder or zip: usually one; copies of several people are separated, or become questions."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from .identifying import Identified, Identifier
from .sanitizing import shown, unique
from .submission_parts import Entry, Piece

_BY_BUNDLE = "the name in the file that hand_in made"
_INSIDE = "the name of what lies in it"


@dataclass(frozen=True)
class Part:
    """The pieces of one person."""

    entry: Entry
    found: Identified
    where: str
    """The entry's name in a question."""
    about: tuple[str, ...]
    """The data that make the question different from others."""


def parts_of(entry: Entry, identifier: Identifier) -> list[Part]:
    """Return an entry as it was handed in, or divided by the owners of its copies."""
    named = identifier.by_name(entry.name)
    whose = [_whose(piece, named, identifier) for piece in entry.pieces]
    known = list(dict.fromkeys(owner for owner in whose if owner is not None))
    everything = _whole(entry, known, identifier)
    if not known or (
        len({owner.people for owner in known}) == 1 and (None not in whose or everything.found is not known[0])
    ):
        return [everything]
    parts = []
    for identified in known:
        pieces = [piece for piece, owner in zip(entry.pieces, whose, strict=True) if owner == identified]
        parts.append(_part(entry, pieces, _settled(entry, pieces, identified, identifier)))
    rest = [piece for piece, owner in zip(entry.pieces, whose, strict=True) if owner is None]
    if rest or entry.faults:
        left = replace(_part(entry, rest, named).entry, faults=entry.faults, concerns=entry.concerns)
        parts.append(replace(_part(entry, rest, named), entry=left))
    return parts


def whole(entry: Entry, found: Identified) -> Part:
    """Return all of an entry. An answer about it holds only for this work: another week's file may have the same name."""
    return Part(entry, found, shown(entry.name), (entry.name, *sorted(piece.digest for piece in entry.pieces)))


def _whole(entry: Entry, known: Sequence[Identified], identifier: Identifier) -> Part:
    identified = identifier.identify(entry.name, unique(piece.known.copy for piece in entry.pieces if piece.known.copy))
    if not identified.people and known:
        identified = known[0]
    if not identified.people and entry.students:
        said = [person for student in unique(entry.students) for person in identifier.by_name(student).people]
        identified = Identified(tuple(dict.fromkeys(said)), _BY_BUNDLE) if said else identified
    return whole(entry, identified)


def _whose(piece: Piece, named: Identified, identifier: Identifier) -> Identified | None:
    """Identify the student of one notebook by its mark; if the entry's name is ambiguous, also by its content."""
    owner = identifier.owner(piece.known.copy)
    if owner is not None:
        return Identified((owner,), "the mark of the copy")
    if len(named.people) == 1:
        return None
    told = [(_BY_BUNDLE, piece.student)] if piece.student else [(_INSIDE, word) for word in piece.where.split("/")]
    for how, name in told:
        people = identifier.by_name(name).people
        if len(people) == 1 and (not named.people or people[0] in named.people):
            return Identified(people, how)
    return None


def _settled(entry: Entry, pieces: Iterable[Piece], identified: Identified, identifier: Identifier) -> Identified:
    """Identify the student by a copy's mark and the entry's name together."""
    marks = unique(piece.known.copy for piece in pieces if identifier.owner(piece.known.copy) is not None)
    return identifier.identify(entry.name, marks) if marks else identified


def _part(entry: Entry, pieces: Sequence[Piece], identified: Identified) -> Part:
    bundles = [file for file in entry.bundles if any(piece.bundle == file for piece in pieces)]
    names = [piece.where for piece in pieces]
    where = shown(f"{entry.name}: {', '.join(names[:3])}{', ...' if len(names) > 3 else ''}", 300)
    return Part(Entry(entry.name, list(pieces), bundles=bundles), identified, where, (entry.name, *sorted(names)))
