"""The arguments of teachers' commands: chapters, the notebooks' folder, the roster of the class."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from coursekit.grade.variants import Variants

ROSTER = "the class: an export of Moodle, Canvas, Blackboard or Google Classroom, a .csv, or a name on each line"
MORE = "How to collect, mark and give back: `coursekit teachers` (docs/teachers.md)"


def chapters_of(known: Sequence[Path], words: Sequence[str]) -> list[Path]:
    """Return the chapters whose names begin with one of the words; every word must match one.

    >>> [path.name for path in chapters_of([Path("02_topics.ipynb"), Path("03_services.ipynb")], ["03"])]
    ['03_services.ipynb']
    """
    unknown = [word for word in words if not any(chapter.name.startswith(word) for chapter in known)]
    if unknown:
        raise SystemExit(f"No chapter begins with {', '.join(unknown)}. There are: {', '.join(p.stem for p in known)}")
    return [chapter for chapter in known if not words or any(chapter.name.startswith(word) for word in words)]


def notebooks_of(args: argparse.Namespace) -> Path:
    """Return the notebooks' folder; reads the checks beside them and reports those that match no notebook."""
    from coursekit.grade.editions import notebooks_folder
    from coursekit.grade.own_checks import OWN, BadChecks, read_checks
    from coursekit.grade.partners import expect_partners

    folder: Path = args.notebooks or notebooks_folder()
    try:
        read_checks(folder / OWN)
        for note in expect_partners(folder):
            print(note, file=sys.stderr)
    except BadChecks as error:
        raise SystemExit(str(error)) from None
    return folder


def variants_of(names: Path | None, *, new: bool = False) -> Variants | None:
    """Return the variants for the named students; `new` creates the class's secret if it has none."""
    try:
        return None if names is None else Variants.read(names, new=new)
    except (ValueError, OSError) as error:
        raise SystemExit(str(error)) from None
