"""The names of a class, as a teacher has them: a text with a name on each line, or a table."""

from __future__ import annotations

import csv
import re
import unicodedata
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path

_HEADINGS = ("student", "students", "name", "names", "full name", "student name")


def student_word(student: str) -> str:
    """A name as it stands in the names of files.

    >>> student_word("Vera de la Course")
    'VeraDeLaCourse'
    """
    return "".join(word[:1].upper() + word[1:] for word in re.findall(r"\w+", student))


def plain(name: str) -> str:
    """A name without what spellings of it differ in.

    >>> plain("Núria O'Neill") == plain("nuria_oneill")
    True
    """
    return re.sub(r"[\W_]", "", unicodedata.normalize("NFKD", name)).casefold()


class Roster:
    """Who is in a class.

    >>> Roster(["Ann Lee", "Ann Leeds"]).find("annleeds_1234_AnnLeeds_03_services")
    'Ann Leeds'
    """

    def __init__(self, students: Sequence[str]) -> None:
        words = {plain(student): student for student in students}
        if len(words) < len(students):
            count = Counter(plain(student) for student in students)
            twice = ", ".join(one for one in students if count[plain(one)] > 1)
            raise ValueError(f"Students have the same name: {twice}. Tell them apart by a number.")
        self.students = list(students)
        self._words = words

    @classmethod
    def read(cls, file: Path) -> Roster:
        """The names in a file: one on each line, or in a table (.csv) the column `student` or `name`, else the first.

        Raises:
            ValueError: when there are none, or two are the same.
        """
        with open(file, newline="", encoding="utf-8-sig") as lines:
            found = list(_column(csv.reader(lines))) if file.suffix == ".csv" else [line.strip() for line in lines]
        names = [name for name in found if plain(name)]
        if not names:
            raise ValueError(f"There are no names in {file}. Write one on each line.")
        return cls(names)

    def find(self, handed_in_by: str) -> str:
        """The student whose name stands in that of a folder or file, the longest if several do; '' if none does."""
        text = plain(handed_in_by)
        fitting = [word for word in self._words if word in text]
        return self._words[max(fitting, key=len)] if fitting else ""


def _column(rows: Iterable[list[str]]) -> Iterable[str]:
    """The names of a table; `Course, Vera` in one cell is Vera Course."""
    place = 0
    for number, row in enumerate(rows):
        headings = [at for at, cell in enumerate(row) if cell.strip().casefold() in _HEADINGS]
        if number == 0 and headings:
            place = headings[0]
        elif len(row) > place:
            last, _, first = row[place].partition(",")
            yield f"{first.strip()} {last.strip()}".strip()
