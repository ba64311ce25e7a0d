"""The student's name: what counts as a whole one, and where a course keeps it for evidence and handing in."""

from __future__ import annotations

import json
from pathlib import Path

from coursekit.files import write_whole

EXERCISE, VARIABLE = "ch00.q1", "me"
"""Where a student writes the name."""
_FILE = "student.json"


def whole_name(text: str) -> str:
    """Return a first and a last name, with single spaces; empty if one of them is missing.

    A dash stands for the part that people with one name do not have. Scripts without capitals, such as Chinese, may have no
    space between the two.

    >>> whole_name(" Vera  Course "), whole_name("山田太郎"), whole_name("Suharto -"), whole_name("Vera")
    ('Vera Course', '山田太郎', 'Suharto', '')
    """
    words = text.split()
    named = [word for word in words if any(map(str.isalpha, word))]
    dashes = [word for word in words if word in ("-", "–", "—")]
    if not named or len(named) + len(dashes) < len(words):
        return ""
    has_no_capitals = len(text.strip()) > 1 and text.upper() == text.lower()
    return " ".join(named) if len(words) > 1 or has_no_capitals else ""


def kept_name(folder: Path) -> str:
    """Return the name that is kept in a course's own folder; empty if there is none."""
    kept = _kept(folder)
    return str(kept.get(VARIABLE, "") if isinstance(kept, dict) else kept or "")


def keep_name(folder: Path, name: str) -> None:
    """Keep a name that was given with `by=`, in place of any other."""
    _keep(folder, name)


def keep_own_name(folder: Path, name: str) -> None:
    """Keep the name of the exercise, unless one was given with `by=`."""
    if not isinstance(_kept(folder), str):
        _keep(folder, {VARIABLE: name})


def _kept(folder: Path) -> str | dict[str, str] | None:
    """Return a text if the name was given with `by=`, a dictionary if it is the exercise's."""
    file = folder / _FILE
    kept: str | dict[str, str] | None = json.loads(file.read_text(encoding="utf-8")) if file.exists() else None
    return kept


def _keep(folder: Path, kept: str | dict[str, str]) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    write_whole(folder / _FILE, json.dumps(kept))


__all__ = ["EXERCISE", "VARIABLE", "keep_name", "keep_own_name", "kept_name", "whole_name"]
