"""A template for a teacher's own chapter: a notebook with one exercise, and its check."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

from .own_checks import OWN

_MARK = "SOLUTION"
"""Separate, because the code installed for students is searched for marks of solutions."""
_CHECK = '''"""The checks of {title}."""

from coursekit.grade.exercise import exercise
from coursekit.grade.plain import near, number
from coursekit.grade.verdict import Wrong
from coursekit.grade.work import Work


@exercise(
    "{name}.q1",
    "The stopping distance",
    points=2,
    hints=("Braking: the distance grows with the square of the speed.", "v squared, divided by twice the deceleration."),
)
def stopping_distance(work: Work) -> None:
    """The same as the formula, for speeds that nobody knows beforehand."""
    function = work.function("stopping_distance")
    dice = work.dice("speeds")
    for _ in range(10):
        speed, deceleration = round(dice.uniform(0.1, 2.0), 2), round(dice.uniform(0.5, 3.0), 2)
        call, right = f"stopping_distance({{speed}}, {{deceleration}})", speed**2 / (2 * deceleration)
        got = number(function(speed, deceleration), f"a number from {{call}}")
        if not near(got, right, 1e-6):
            raise Wrong(f"{{right:.3f}} m from {{call}}", gave=f"{{got:.3f}} m", cause="Is the speed squared?")
'''


def write_template(folder: Path, name: str) -> list[Path]:
    """Write `NAME.ipynb` and `checks/NAME.py` to a folder. Returns the files.

    Raises:
        ValueError: for a name that is not a Python identifier.
        FileExistsError: when one of them exists.
    """
    if not name.isidentifier():
        raise ValueError(f"'{name}' cannot be the name of exercises: use letters, digits and _, as in gripper")
    title = name.replace("_", " ").capitalize()
    texts = {
        folder / f"{name}.ipynb": json.dumps(_notebook(title, name), indent=1) + "\n",
        folder / OWN / f"{name}.py": _CHECK.format(title=title, name=name),
    }
    there = [file.name for file in texts if file.exists()]
    if there:
        raise FileExistsError(f"{', '.join(there)} exists in {folder}: take another name, or move it away")
    for file, text in texts.items():
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    return list(texts)


def _notebook(title: str, name: str) -> dict[str, Any]:
    answer = [
        "def stopping_distance(speed: float, deceleration: float) -> float:\n",
        '    """Metres from full speed to a stop."""\n',
        f"    ### BEGIN {_MARK}\n",
        "    return speed**2 / (2 * deceleration)\n",
        f"    ### END {_MARK}",
    ]
    exercise = (
        "## Exercise 1 (2 points): the stopping distance\n\nA robot that drives at `speed` (m/s) brakes with `deceleration` "
        "(m/s²). Write `stopping_distance`, which returns how far it still goes, in metres."
    )
    cells = [
        _cell("markdown", [f"# {title}\n\nWhat this chapter is about, in two sentences."]),
        _cell("code", ["from coursekit.lab import *\n", "\n", "reset()"]),
        _cell("markdown", [exercise]),
        _cell("code", answer, _grading(f"{name}-q1", solution=True)),
        _cell("code", [f'check("{name}.q1")'], _grading(f"{name}-q1-check", grade=True, locked=True)),
    ]
    kernel = {"display_name": "Python 3 (ipykernel)", "language": "python", "name": "python3"}
    return {"nbformat": 4, "nbformat_minor": 5, "metadata": {"kernelspec": kernel}, "cells": cells}


def _cell(kind: str, source: list[str], metadata: dict[str, Any] | None = None) -> dict[str, Any]:
    name = hashlib.sha256("".join(source).encode()).hexdigest()[:8]
    cell: dict[str, Any] = {"cell_type": kind, "id": f"{kind}-{name}", "metadata": metadata or {}}
    if kind == "code":
        cell |= {"outputs": [], "execution_count": None}
    return {**cell, "source": source}


def _grading(name: str, **kind: bool) -> dict[str, Any]:
    usual = {"grade": False, "solution": False, "locked": False, "task": False, "schema_version": 3, "grade_id": name}
    return {"nbgrader": {**usual, **kind, **({"points": 2} if kind.get("grade") else {})}}


__all__ = ["write_template"]
