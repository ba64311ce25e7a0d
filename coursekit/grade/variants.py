"""Individual values: each student's copy has other numbers and names, drawn with the teacher's secret.

A check cell declares the variants of its exercise, with the value in the course's notebook first: `"metadata":
{"coursekit": {"variants": {"boxes": [10, 7, 12]}}}`, or `{"from": 5, "to": 20, "step": 1, "default": 10}`. A copy has
its value in place of the first one, between the exercise's heading and its check; the check contains it too:
`check("ch03.q3", boxes=12)`. Grading draws the value again and does not trust the copy.
"""

from __future__ import annotations

import ast
import hashlib
import hmac
import json
import os
import re
import secrets
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from .roster import Person, Roster

Values = dict[str, dict[str, Any]]
"""The values by exercise and name."""
CHECK = re.compile(r"""^[ \t]*check\(\s*["'](?P<name>[\w.]+)["']\s*(?:,[^\n]*)?\)[ \t]*$""", re.M)
_HEADING = re.compile(r"^#{1,3} ", re.M)


def checks_in(notebook: Mapping[str, Any]) -> dict[str, int]:
    """Return the exercises that a notebook checks, with the indices of the cells.

    >>> checks_in({"cells": [{"cell_type": "markdown"}, {"cell_type": "code", "source": ['check("relay")']}]})
    {'relay': 1}
    """
    checks: dict[str, int] = {}
    for place, cell in enumerate(notebook.get("cells", [])):
        for match in CHECK.finditer("".join(cell.get("source", ""))) if cell.get("cell_type") == "code" else ():
            checks.setdefault(match["name"], place)
    return checks


def told(notebook: Mapping[str, Any]) -> Values:
    """Return the values in the checks of a notebook.

    >>> told({"cells": [{"cell_type": "code", "source": ['check("relay", topic="/upper", depth=3)']}]})
    {'relay': {'topic': '/upper', 'depth': 3}}
    """
    values: Values = {}
    for name, place in checks_in(notebook).items():
        line = CHECK.search("".join(notebook["cells"][place]["source"]))
        try:
            call: Any = ast.parse(line[0].strip(), mode="eval").body if line else None
            values[name] = {keyword.arg: ast.literal_eval(keyword.value) for keyword in call.keywords if keyword.arg}
        except (ValueError, SyntaxError, AttributeError):
            values[name] = {}
    return values


def values_of(notebooks: Iterable[Mapping[str, Any]]) -> Values:
    """Return the values in the checks of several notebooks, for exercises that have any."""
    return {name: said for notebook in notebooks for name, said in told(notebook).items() if said}


def declared(notebook: Mapping[str, Any]) -> dict[str, dict[str, list[Any]]]:
    """Return the choices by exercise and name, first the one in the notebook."""
    declared = {}
    for name, place in checks_in(notebook).items():
        said = notebook["cells"][place].get("metadata", {}).get("coursekit", {}).get("variants", {})
        if said:
            declared[name] = {value: _choices(told_value) for value, told_value in said.items()}
    return declared


def _choices(said: Any) -> list[Any]:
    if isinstance(said, list):
        return said
    steps = round((said["to"] - said["from"]) / said["step"])
    return [said["default"], *(round(said["from"] + step * said["step"], 9) for step in range(steps + 1))]


def personal(notebook: Mapping[str, Any], values: Values) -> dict[str, Any]:
    """Return the notebook with these values in place of its own."""
    personal: dict[str, Any] = json.loads(json.dumps(notebook))
    places, known = checks_in(notebook), declared(notebook)
    for name, chosen in values.items():
        own = {_written(known[name][place][0]): _written(value) for place, value in chosen.items()}
        for cell in personal["cells"][_heading(personal, places[name]) : places[name]]:
            head, text, _ = _parted(cell)
            cell["source"] = (head + _exchanged(text, own)).splitlines(keepends=True)
        check = personal["cells"][places[name]]
        line = ", ".join([f'"{name}"', *(f"{place}={value!r}" for place, value in chosen.items())])
        check["source"] = [f"check({line})"]
        del check["metadata"]["coursekit"]
    return personal


def _heading(notebook: Mapping[str, Any], place: int) -> int:
    """Return the index of the cell with the exercise's heading."""
    return max((above for above in range(place) if _parted(notebook["cells"][above])[2]), default=0)


def _parted(cell: Mapping[str, Any]) -> tuple[str, str, bool]:
    """Return the text above a cell's last heading, the rest, and whether there is a heading."""
    text = "".join(cell["source"])
    places = [match.start() for match in _HEADING.finditer(text)] if cell["cell_type"] == "markdown" else []
    begin = max(places, default=0)
    return text[:begin], text[begin:], bool(places)


def _written(value: Any) -> str:
    return value if isinstance(value, str) else repr(value)


def _exchanged(text: str, own: Mapping[str, str]) -> str:
    """Replace whole words and numbers in a text.

    >>> _exchanged("10 boxes of 10.5 kg: 10.", {"10": "7"})
    '7 boxes of 10.5 kg: 7.'
    """
    words = "|".join(re.escape(name) for name in sorted(own, key=len, reverse=True))
    return re.sub(rf"(?<![\w.])(?:{words})(?!\w|\.\d)", lambda match: own[match[0]], text)


class Variants:
    """A class and its secret.

    >>> Variants(Roster(["Vera Course"]), b"secret").of("Vera Course", {"cells": []})
    {}
    """

    def __init__(self, roster: Roster, secret: bytes) -> None:
        self.roster = roster
        self._secret = secret

    @classmethod
    def read(cls, students: Path, *, new: bool = False) -> Variants:
        """Read a class from its list, and its secret from NAME.secret beside it, created if `new`.

        Raises:
            ValueError: when the names are invalid, or the secret is missing.
        """
        roster, file = Roster.read(students), secret_file(students)
        if new and not file.exists():
            with open(os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w", encoding="utf-8") as out:
                out.write(secrets.token_hex(16) + "\n")
        if not file.is_file():
            raise ValueError(f"There is no {file}, the secret that the copies were made with: put it back beside the names.")
        return cls(roster, file.read_text(encoding="utf-8").strip().encode())

    def of(self, student: str, notebook: Mapping[str, Any]) -> Values:
        """Return a student's values for the exercises of a notebook."""
        return {
            exercise: {name: self._drawn(student, exercise, name, choices) for name, choices in names.items()}
            for exercise, names in declared(notebook).items()
        }

    def copy_mark(self, person: Person) -> str:
        """Return the mark of a person's copies, which reveals the owner only to the teacher."""
        key = hmac.new(self._secret, f"copy\0{person.identity}".encode("utf-8", "replace"), hashlib.sha256)
        return key.hexdigest()[:24]

    def copy_marks(self) -> dict[str, Person]:
        """Return the owner of each copy mark."""
        return {self.copy_mark(person): person for person in self.roster.people}

    def dice(self) -> bytes:
        """Return the seed of the judges' random choices: constant, and the same for the whole class."""
        return hmac.new(self._secret, b"dice", hashlib.sha256).digest()

    def copies(self, student: str, notebooks: Mapping[str, Any]) -> dict[str, Any]:
        """Return the student's own notebooks, by file name."""
        return {name: personal(notebook, self.of(student, notebook)) for name, notebook in notebooks.items()}

    def _drawn(self, student: str, exercise: str, name: str, choices: list[Any]) -> Any:
        """Draw a value, which is unpredictable without the secret."""
        key = hmac.new(self._secret, "\0".join((student, exercise, name)).encode(), hashlib.sha256)
        kinds = list(dict.fromkeys(choices))
        return kinds[int.from_bytes(key.digest()[:8], "big") % len(kinds)]


def secret_file(students: Path) -> Path:
    """Return the file with the secret of a class.

    >>> secret_file(Path("class.csv")).name
    'class.secret'
    """
    return students.with_suffix(".secret")
