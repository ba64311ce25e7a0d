"""Choose the file that counts for a chapter among a person's files, and give the reason. Ambiguities become questions.

The criteria, in this order: readable files; no checkpoints; work on exercises before other work before an untouched
copy; with `in-time`, files from before the deadline; then the newest. At the same age, or within one hand-in, more
work counts.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import PurePosixPath

from .questions import Question, numbered
from .sanitizing import shown
from .submission_parts import Piece, told_time

NEWEST, IN_TIME = "newest", "in-time"
SAME_S = 2.0
"""The tolerance within which times are equal [s]: zips have a resolution of 2 s, and unpacking sets all times at once."""


@dataclass(frozen=True)
class Choice:
    """The file that counts, or a question."""

    piece: Piece | None = None
    why: str = ""
    """The reason, if there was a choice."""
    question: Question | None = None


def choose(
    pieces: Sequence[Piece], who: str, count: str, deadline: float | None, answers: Mapping[str, str]
) -> Choice:
    """Return the file that counts, of those that one person handed in for one chapter."""
    left = _fitting(sorted(pieces, key=_order))
    if count == IN_TIME and deadline is not None:
        left = [piece for piece in left if piece.when <= deadline] or left
    left = _different(left)
    question = _question(pieces[0].chapter, left, who)
    said = question.chosen(answers)
    if len(left) > 1 and said in question.choices:
        named = left[question.choices.index(said)]
        return Choice(named, _why(named, pieces, "as the teacher decided"), question)
    newest = _newest(left)
    if len(newest) == 1:
        best = newest[0]
        fuller = [piece for piece in left if piece.entry == best.entry and _more(piece, best)]
        if not fuller:
            return Choice(best, _why(best, pieces, ""))
    return Choice(None, question=question)


def _order(piece: Piece) -> tuple[float, float, str]:
    return (piece.when, piece.inner, piece.where)


def _fitting(pieces: Sequence[Piece]) -> list[Piece]:
    left = [piece for piece in pieces if not piece.fault] or list(pieces)
    left = [piece for piece in left if not piece.checkpoint] or left
    level = max(piece.known.level for piece in left)
    return [piece for piece in left if piece.known.level == level]


def _different(pieces: Sequence[Piece]) -> list[Piece]:
    """Return the oldest of files with the same work, preferring one named after the chapter."""
    piece_by_work: dict[str, Piece] = {}
    for piece in pieces:
        work = piece.known.work if not piece.fault else piece.digest or piece.where
        kept = piece_by_work.setdefault(work, piece)
        if _named(piece) and not _named(kept) and piece.when - kept.when <= SAME_S:
            piece_by_work[work] = piece
    return list(piece_by_work.values())


def _named(piece: Piece) -> bool:
    return PurePosixPath(piece.where).name == piece.chapter


def _newest(pieces: Sequence[Piece]) -> list[Piece]:
    """Return the newest file, or several if they are equally new and none contains the work of all others."""
    newest = max(piece.when for piece in pieces)
    left = [piece for piece in pieces if newest - piece.when <= SAME_S]
    latest = max(piece.inner for piece in left)
    left = [piece for piece in left if latest - piece.inner <= SAME_S]
    return [piece for piece in left if all(_more(piece, other) for other in left if other is not piece)] or left


def _more(one: Piece, other: Piece) -> bool:
    return set(one.known.begun) > set(other.known.begun)


def _question(chapter: str, left: Sequence[Piece], who: str) -> Question:
    places = _places(left)
    facts = zip(places, left, strict=True)
    about = "; ".join(
        f"{place}: {told_time(piece.when)}, exercises begun: {len(piece.known.begun)}" for place, piece in facts
    )
    number = numbered("which", who, chapter, *sorted(piece.digest for piece in left))
    text = f"Which of these is {who}'s {PurePosixPath(chapter).stem}? Write its path or its place."
    return Question(number, text, about, tuple(places))


def _places(pieces: Sequence[Piece]) -> list[str]:
    """Return the location of each file; with its hand-in where two would have the same name."""
    wheres = [piece.where for piece in pieces]
    told = [piece.where if wheres.count(piece.where) == 1 else f"{shown(piece.entry)}/{piece.where}" for piece in pieces]
    return [
        text if told.count(text) == 1 else f"{text} (number {told[: at + 1].count(text)})" for at, text in enumerate(told)
    ]


def _why(best: Piece, pieces: Sequence[Piece], how: str) -> str:
    others = sorted((piece for piece in pieces if piece is not best), key=_order)
    if not others and best.checkpoint:
        return f"{best.where} counts: only this checkpoint was handed in"
    if not others:
        return ""
    own, *places = _places([best, *others])
    said = ", ".join(f"{place} ({_against(piece, best)})" for place, piece in list(zip(places, others, strict=True))[:6])
    return f"{own} counts{', ' + how if how else ''}; not {said}"


def _against(other: Piece, best: Piece) -> str:
    """Return why a file does not count."""
    if other.fault:
        return "cannot be read"
    if other.checkpoint and not best.checkpoint:
        return "a checkpoint"
    if other.known.level < best.known.level:
        return "nothing was written in it" if not other.known.level else "no exercise was begun in it"
    if other.known.work == best.known.work:
        return "the same work"
    return "newer" if other.when > best.when else f"of {told_time(other.when)}" if other.when else "older"
