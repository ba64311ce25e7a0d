"""Submissions that look copied: the same code after removal of names, spaces and comments."""

from __future__ import annotations

import io
import itertools
import keyword
import tokenize
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from .sanitizing import cell
from .tables import COMMA, Form, write_table

if TYPE_CHECKING:
    from .mark import Marked

SHINGLE = 8
"""The number of tokens compared at a time."""
ALIKE = 0.85
FEWEST = 40
"""The number of shingles below which all answers look the same."""

LARGE, USUAL = 10, 0.8
"""The class size and the share of students above which common code is ignored; in small classes it may be copied."""


def shingles(answers: Sequence[str]) -> set[tuple[str, ...]]:
    """Return the runs of tokens in the answers; all names count as equal.

    >>> shingles(["a = b + 1"]) == shingles(["speed=limit+1  # fast"])
    True
    """
    tokens = [token for answer in answers for token in _tokens(answer)]
    width = min(SHINGLE, max(1, len(tokens)))
    return {tuple(tokens[at : at + width]) for at in range(len(tokens) - width + 1)}


def _tokens(text: str) -> list[str]:
    kept = []
    code = "\n".join(line.lstrip() for line in text.splitlines() if not line.startswith("%"))  # lines may be fragments
    try:
        for token in tokenize.generate_tokens(io.StringIO(code).readline):
            if token.type == tokenize.NAME:
                kept.append(token.string if keyword.iskeyword(token.string) else "name")
            elif token.type in (tokenize.OP, tokenize.NUMBER, tokenize.STRING):
                kept.append(token.string)
    except (tokenize.TokenError, SyntaxError):
        kept += code.split()
    return kept


def similar(marks: Sequence[Marked]) -> list[tuple[str, str, float]]:
    """Return (student, student, similarity) of pairs with nearly the same work, most similar first.

    Code of nearly everybody in a large class is ignored: it is from the course's stubs, or there is only one
    solution.
    """
    answers = {mark.student: shingles(mark.answers) for mark in marks if mark.answers}
    common = Counter(part for parts in answers.values() for part in parts)
    usual = {part for part, number in common.items() if number > USUAL * len(answers)} if len(answers) >= LARGE else set()
    own = {student: parts - usual for student, parts in answers.items()}
    pairs = []
    for one, other in itertools.combinations(sorted(own), 2):
        both = own[one] & own[other]
        if len(both) >= FEWEST and len(both) / len(own[one] | own[other]) >= ALIKE:
            pairs.append((one, other, round(len(both) / len(own[one] | own[other]), 3)))
    return sorted(pairs, key=lambda pair: (-pair[2], pair[:2]))


def write_similar(file: Path, marks: Sequence[Marked], form: Form = COMMA) -> None:
    """Write the pairs as a table: hints for the teacher, not a verdict."""
    rows = [(cell(one), cell(other), form.number(likeness)) for one, other, likeness in similar(marks)]
    write_table(file, ["student", "other", "likeness"], rows, form)
