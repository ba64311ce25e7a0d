"""Questions for the teacher: a table with an empty column for answers, which the next run reads."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

from .sanitizing import cell
from .tables import COMMA, Form, read_table, write_table

NAME = "questions.csv"
NOBODY = "nobody"
HEADINGS = ("number", "question", "about", "choices", "answer")


@dataclass(frozen=True)
class Question:
    """A question in place of a guess."""

    number: str
    """A digest of its subject: an answer counts as long as the subject is unchanged."""
    text: str
    about: str
    choices: tuple[str, ...] = ()

    def chosen(self, answers: Mapping[str, str]) -> str:
        """Return the answer; '' if there is none yet. A choice can be given by its number: `2`."""
        said = answers.get(self.number, "").strip().strip("'")
        if said.isdigit() and said not in self.choices and 0 < int(said) <= len(self.choices):
            return self.choices[int(said) - 1]
        same = [
            choice
            for choice in self.choices
            if cell(choice).casefold() == said.casefold() or choice.casefold() == said.casefold()
        ]
        return same[0] if same else said


def numbered(*about: str) -> str:
    """Return the number of a question about this subject.

    >>> numbered("whose", "x.ipynb")
    'Q97ae6d7c'
    """
    return "Q" + hashlib.sha256("\0".join(about).encode("utf-8", "surrogatepass")).hexdigest()[:8]


def read_answers(file: Path) -> dict[str, str]:
    """Return the answers in the table so far.

    Raises:
        ValueError: when the table cannot be read.
    """
    if not file.is_file():
        return {}
    answer_by_number = {row.get("number", ""): row.get("answer", "").strip() for row in read_table(file).dicts()}
    return {number: answer for number, answer in answer_by_number.items() if number and answer}


def write_questions(
    file: Path, asked: Iterable[Question], answers: Mapping[str, str], form: Form = COMMA
) -> None:
    """Write all questions, answered or not, with earlier answers. A table without rows is removed."""
    rows = {
        question.number: [question.number, cell(question.text), cell(question.about), cell(" | ".join(question.choices)),
                     cell(answers.get(question.number, ""))]
        for question in asked
    }  # fmt: skip
    for row in read_table(file).dicts() if file.is_file() else []:
        if row.get("number") and row.get("answer"):
            rows.setdefault(row["number"], [cell(row.get(heading, "")) for heading in HEADINGS])
    if rows:
        write_table(file, HEADINGS, rows.values(), form)
    else:
        file.unlink(missing_ok=True)
