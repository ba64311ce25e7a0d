"""Check that a teacher's own notebooks and checks match: each check has its exercise, each exercise its check."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from coursekit.suggestions import similar

from .exercise import all_exercises
from .own_checks import OWN, BadChecks, own_files
from .recognising import grade_id
from .variants import checks_in


def expect_partners(folder: Path) -> list[str]:
    """Return a note for each exercise in `folder/checks` without a check in the folder's notebooks.

    Raises:
        BadChecks: when a notebook checks an unknown exercise, or two of its cells have the same name.
    """
    if not (folder / OWN).is_dir():
        return []
    notebooks = {file.name: json.loads(file.read_text(encoding="utf-8")) for file in sorted(folder.glob("*.ipynb"))}
    for name, notebook in notebooks.items():
        _expect_exercises(name, notebook)
        _expect_names(name, notebook)
    checked = {name for notebook in notebooks.values() for name in checks_in(notebook)}
    own = set((folder / OWN).resolve().glob("*.py"))
    left = [
        exercise
        for exercise in all_exercises().values()
        if exercise.name not in checked and own & set(own_files([exercise]))
    ]
    return [f'{OWN}: no notebook has check("{exercise.name}"), so nobody is asked for it.' for exercise in left]


def _expect_exercises(name: str, notebook: Mapping[str, Any]) -> None:
    known = all_exercises()
    for asked in checks_in(notebook):
        if asked not in known:
            near = similar(asked, known, 3)
            hint = f" Near names: {', '.join(near)}." if near else ""
            raise BadChecks(f'{name} has check("{asked}"), and there is no @exercise("{asked}") in {OWN}/.{hint}')


def _expect_names(name: str, notebook: Mapping[str, Any]) -> None:
    counts = Counter(grade_id(cell) for cell in notebook["cells"])
    for cell, count in counts.items():
        if cell and count > 1:
            raise BadChecks(f"{name}: {count} cells are called {cell} (nbgrader's ID). Each needs a name of its own.")


__all__ = ["expect_partners"]
