"""Exercises by name; each chapter's are in `coursekit.grade.chapters`."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from coursekit.suggestions import similar

from . import chapters
from .variants import checks_in


@dataclass(frozen=True)
class Exercise:
    """An exercise; `judge(work)` raises `Wrong` when the work does not solve it.

    An exercise without points is voluntary: it is checked in the notebook, and is no part of a mark.
    """

    name: str
    title: str
    points: float
    hints: tuple[str, ...]
    judge: Callable[[Any], None]


class UnknownExercise(LookupError):
    """There is no exercise of that name; the message lists existing ones."""

    def _render_traceback_(self) -> list[str]:
        """Return the text that IPython shows instead of a traceback."""
        return [str(self)]


_known: dict[str, Exercise] = {}


def exercise(
    name: str, title: str, points: float = 1, hints: tuple[str, ...] = ()
) -> Callable[[Callable[[Any], None]], Callable[[Any], None]]:
    """Register the decorated function as the judge of an exercise."""

    def register(judge: Callable[[Any], None]) -> Callable[[Any], None]:
        _known[name] = Exercise(name, title, points, hints, judge)
        return judge

    return register


def all_exercises() -> dict[str, Exercise]:
    """Return every exercise by name, in the order of the course."""
    for module in pkgutil.iter_modules(chapters.__path__):
        importlib.import_module(f"{chapters.__name__}.{module.name}")
    return dict(sorted(_known.items()))


def checked_in(*notebooks: Mapping[str, Any]) -> dict[str, Exercise]:
    """Return the exercises that the notebooks check."""
    checked = {name for notebook in notebooks for name in checks_in(notebook)}
    return {name: known for name, known in all_exercises().items() if name in checked}


def exercises_in(*notebooks: Mapping[str, Any]) -> dict[str, Exercise]:
    """Return the checked exercises that have points and form the mark."""
    return {name: exercise for name, exercise in checked_in(*notebooks).items() if exercise.points}


def find(name: str) -> Exercise:
    """Return the exercise of that name; UnknownExercise lists those of its chapter, or similar names."""
    known = all_exercises()
    if type(name) is str and name in known:
        return known[name]
    said = str(name)[:40]
    of_chapter = [name for name in known if name.startswith(said.partition(".")[0] + ".")]
    close = of_chapter or similar(said, known, 3)
    there = f"There are: {', '.join(close)}." if close else "Names are like ch02.q1 and appb.q1."
    raise UnknownExercise(f"There is no exercise '{said}'. {there}")
