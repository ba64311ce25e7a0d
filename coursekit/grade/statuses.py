"""The status of each person's work, named and counted in the same way everywhere."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .mark import Marked

QUESTION, NOTHING, NOT_MARKED, UNREADABLE, EMPTY, TIMED_OUT, ELSEWHERE, LATE, GRADED = STATUSES = (
    "question",
    "nothing handed in",
    "not marked",
    "unreadable",
    "empty",
    "timed out",
    "ran elsewhere",
    "late",
    "graded",
)
"""The first that applies is the status. The last two and `nothing handed in` need no attention of the teacher."""
LOOK = tuple(status for status in STATUSES if status not in (GRADED, NOTHING, LATE))


def status_of(marked: Marked | None, *, opened: bool, handed_in: bool, late: bool, tier: str) -> str:
    """Return the status of a person: `opened` means an open question, `tier` is this run's sandbox tier."""
    if opened:
        return QUESTION
    if marked is None:
        return NOT_MARKED if handed_in else NOTHING
    if marked.status == "error" or any(verdict.fault for verdict in marked.verdicts):
        return NOT_MARKED
    if marked.status in (UNREADABLE, EMPTY):
        return marked.status
    if any(verdict.timed_out for verdict in marked.verdicts):
        return TIMED_OUT
    if marked.tier and marked.tier != tier:
        return ELSEWHERE
    return LATE if late else GRADED


_WORDS = {QUESTION: "with an open question", NOTHING: "without anything handed in"}
"""Descriptions of a number of students, where the status itself does not fit."""


def by_status(statuses: Iterable[str]) -> dict[str, int]:
    """Return the number of each status, in a fixed order.

    >>> by_status(["graded", "late", "graded"])
    {'late': 1, 'graded': 2}
    """
    listed: Sequence[str] = list(statuses)
    return {status: listed.count(status) for status in STATUSES if status in listed}


def told(counts: dict[str, int]) -> str:
    """Format the counts as text.

    >>> told({"question": 1, "nothing handed in": 2, "graded": 31})
    '31 graded, 2 without anything handed in, 1 with an open question'
    """
    return ", ".join(f"{number} {_WORDS.get(status, status)}" for status, number in reversed(list(counts.items())))
