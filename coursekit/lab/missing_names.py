"""Names that other cells define: after a kernel restart they are missing, and the cell prints which cells to run."""

from __future__ import annotations

import ast
import json
import os
from collections.abc import Iterable, Iterator
from pathlib import Path

from IPython.core.inputtransformer2 import TransformerManager
from IPython.core.interactiveshell import ExecutionResult, InteractiveShell

from coursekit.files import read_text
from coursekit.words.gettext import gettext


def install(shell: InteractiveShell) -> None:
    """Print advice after a cell that ends with a NameError for a name that another cell defines."""
    shell.events.register("post_run_cell", _look)


def _look(result: ExecutionResult) -> None:
    error = result.error_in_exec
    if isinstance(error, NameError) and error.name and (said := advice(error.name, _cells())):
        print(said)


def advice(name: str, cells: Iterable[str]) -> str:
    """Return advice about a missing name; empty unless one of these cells defines it.

    >>> advice("robot", ["%cd -q src", "robot = load('vera.urdf')"]).split(".")[0]
    '`robot` is made in another cell'
    >>> advice("robt", ["robot = 1"])
    ''
    """
    trees = [tree for source in cells if (tree := _parsed(source)) is not None]
    made, imported = (any(name in names(tree) for tree in trees) for names in (_made_by, _imported_by))
    if not made and not imported:
        return ""
    first = gettext(
        "After a restart run those above first: menu Run, Run All Above Selected Cell. "
        "It stops at a check that is not passed yet: go on below it."
    )
    if made:
        return gettext(f"`{name}` is made in another cell. {first}")
    return gettext(f"`{name}` is imported in another cell. {first}")


def _parsed(source: str) -> ast.Module | None:
    """Return the syntax of a cell; None for a cell that is not Python."""
    try:
        return ast.parse(TransformerManager().transform_cell(source))
    except SyntaxError:
        return None


def _made_by(tree: ast.Module) -> Iterator[str]:
    """Yield the names that a cell assigns or defines."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            yield node.id
        elif isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            yield node.name


def _imported_by(tree: ast.Module) -> Iterator[str]:
    for node in ast.walk(tree):
        if isinstance(node, ast.alias):
            yield node.asname or node.name.partition(".")[0]


def _cells() -> list[str]:
    """Return the code cells of this kernel's notebook as last saved; empty if it has no file."""
    try:
        saved = json.loads(read_text(Path(os.environ.get("JPY_SESSION_NAME", ""))))
        return ["".join(cell["source"]) for cell in saved["cells"] if cell["cell_type"] == "code"]
    except (OSError, ValueError, KeyError, TypeError):
        return []


__all__ = ["advice", "install"]
