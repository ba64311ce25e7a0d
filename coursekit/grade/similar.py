"""Submissions that look copied: the same code after names, spaces and comments are taken out."""

from __future__ import annotations

import io
import itertools
import keyword
import tokenize
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from .harmless import cell
from .tables import COMMA, Form, write_table

if TYPE_CHECKING:
    from .mark import Marked

SHINGLE = 8
"""Tokens that are compared at a time."""
ALIKE = 0.85
FEWEST = 40
"""Shingles below which everybody's answer looks the same."""

LARGE, USUAL = 10, 0.8
"""Students of a class, and the part of them, above which what all wrote says nothing: of five, three who copied are many."""


def shingles(answers: Sequence[str]) -> set[tuple[str, ...]]:
    """The runs of tokens in the answers; names count as one and the same.

    >>> shingles(["a = b + 1"]) == shingles(["speed=limit+1  # fast"])
    True
    """
    tokens = [token for answer in answers for token in _tokens(answer)]
    width = min(SHINGLE, max(1, len(tokens)))
    return {tuple(tokens[at : at + width]) for at in range(len(tokens) - width + 1)}


def _tokens(text: str) -> list[str]:
    kept = []
    code = "\n".join(line.lstrip() for line in text.splitlines() if not line.startswith("%"))  # lines may stand alone
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
    """(student, student, likeness) of pairs whose work is nearly one, most alike first.

    What nearly everybody in a large class wrote does not count: it stood in the course's own stubs, or there is one way.
    """
    found = {one.student: shingles(one.answers) for one in marks if one.answers}
    common = Counter(part for parts in found.values() for part in parts)
    usual = {part for part, number in common.items() if number > USUAL * len(found)} if len(found) >= LARGE else set()
    own = {student: parts - usual for student, parts in found.items()}
    pairs = []
    for one, other in itertools.combinations(sorted(own), 2):
        both = own[one] & own[other]
        if len(both) >= FEWEST and len(both) / len(own[one] | own[other]) >= ALIKE:
            pairs.append((one, other, round(len(both) / len(own[one] | own[other]), 3)))
    return sorted(pairs, key=lambda pair: (-pair[2], pair[:2]))


def write_similar(file: Path, marks: Sequence[Marked], form: Form = COMMA) -> None:
    """The pairs as a table: where to look, not a verdict."""
    rows = [(cell(one), cell(other), form.number(likeness)) for one, other, likeness in similar(marks)]
    write_table(file, ["student", "other", "likeness"], rows, form)
