"""What the cells run before a check explain: the answer's cell failed, or its function has another name there."""

from __future__ import annotations

import ast
import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from typing import Any

from coursekit.suggestions import similar

from .answer_age import fault_of, older
from .verdict import Verdict

_DEFINED = re.compile(r"^(?:async )?def (\w+)", re.MULTILINE)
_ALIKE = 0.8
"""The minimum similarity of a misspelt name: `full_nam` has 0.94 of `full_name`, another name of three words has less."""


def explained(verdict: Verdict, asked: Collection[str], shell: Any) -> Verdict:
    """Return the verdict with such an explanation as its likely cause; `asked` are the names that the judge looked for.

    What an older run has left behind does not pass.
    """
    if verdict.fault or shell is None or (verdict.passed and not older(asked)):
        return verdict
    before = shell.last_execution_result
    cause = _failed(before, asked) if before else ""
    cause = cause or (_set_under_another_name(before, asked, shell.user_ns) if before else "")
    cause = cause or _misspelt(shell.user_ns.get("In", ()), asked) or older(asked)
    if verdict.passed:
        return replace(verdict, points=0, expected="the answer as it is in the notebook now", cause=cause)
    return replace(verdict, cause=cause, hint="") if cause else verdict


def _failed(before: Any, asked: Collection[str]) -> str:
    """Return what to say if the cell before the check failed and has to do with the exercise."""
    if not isinstance(before.error_before_exec or before.error_in_exec, Exception):  # an interrupt is no fault
        return ""
    fault = fault_of(before)
    if not fault or not _is_about(before, asked):
        return ""
    return f"The cell before this check stopped with {fault}. What was judged is older: mend that cell and run it."


def _is_about(before: Any, asked: Collection[str]) -> bool:
    """Whether a failed cell mentions what the judge looked for; a stub is always part of an exercise."""
    if not asked or isinstance(before.error_in_exec, NotImplementedError):
        return True
    words = set(re.findall(r"\w+", before.info.raw_cell or ""))
    return not words.isdisjoint(asked)


def _set_under_another_name(before: Any, asked: Collection[str], variables: Collection[str]) -> str:
    """Return what to say if the cell before the check set a variable with a name like the one that is judged.

    A cell that uses the judged name at all, as in `moves[0] = move`, has no slip in it; of a name that does not exist
    the verdict itself says which one is like it.
    """
    if before.error_before_exec or before.error_in_exec or not (tree := _tree(before.info.raw_cell or "")):
        return ""
    used = set(_used(tree))
    set_there = {name.lower(): name for name in _set(tree) if name not in asked}
    for name in asked:
        if name in variables and name not in used and (alike := similar(name.lower(), set_there, cutoff=_ALIKE)):
            slip = f"The cell before this check sets `{set_there[alike[0]]}`, and `{name}` is judged, which is older."
            return f"{slip} Is the name a slip?"
    return ""


def _tree(cell: str) -> ast.Module | None:
    """Return a cell as Python code, with its magics as calls; None if it is no code, or a piece of an indented block."""
    from IPython.core.inputtransformer2 import TransformerManager

    if cell.lstrip("\n")[:1].isspace():
        return None  # IPython would take the indentation away
    try:
        return ast.parse(TransformerManager().transform_cell(cell))
    except (SyntaxError, ValueError):
        return None


def _set(tree: ast.Module) -> Iterator[str]:
    """Yield the variables that a cell sets, also several in one line: `a, b = 1, 2`."""
    for line in tree.body:
        if isinstance(line, ast.Assign) or (isinstance(line, ast.AnnAssign) and line.value):
            targets = line.targets if isinstance(line, ast.Assign) else [line.target]
            parts = (part for target in targets for part in ast.walk(target))
            yield from (part.id for part in parts if isinstance(part, ast.Name) and isinstance(part.ctx, ast.Store))


def _used(tree: ast.Module) -> Iterator[str]:
    """Yield every name that a cell reads, sets, defines or imports."""
    for part in ast.walk(tree):
        if isinstance(part, ast.Name):
            yield part.id
        elif isinstance(part, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            yield part.name
        elif isinstance(part, ast.alias):
            yield part.asname or part.name


def _misspelt(cells: Sequence[str], asked: Collection[str]) -> str:
    """Return what to say if a function was last defined under a name like the one that the judge looked for."""
    for name in asked:
        last = max((place for place, cell in enumerate(cells) if name in _DEFINED.findall(cell)), default=None)
        if last is None:
            continue
        older = set(_DEFINED.findall("\n".join(cells[: last + 1])))
        newer = set(_DEFINED.findall("\n".join(cells[last + 1 :]))) - older
        if alike := similar(name, newer, cutoff=_ALIKE):
            slip = f"A newer cell defines `{alike[0]}`. What was judged is `{name}`, which is older. Is the name a slip?"
            return f"{slip} Mend it in that cell and run it."
    return ""


__all__ = ["explained"]
