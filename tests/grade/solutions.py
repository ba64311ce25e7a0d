"""The solutions of all chapters, and whether one of them stands in a text: by marker, by text, by syntax tree."""

import ast
import functools
import json
import re
import textwrap
from pathlib import Path

NOTEBOOKS = Path(__file__).resolve().parents[2] / "notebooks"
MARKER = "### BEGIN SOLUTION"
_BETWEEN = re.compile(r"### BEGIN SOLUTION\n(.*?)\n[ \t]*(?:// )?### END SOLUTION", re.S)
SHORT = 40
"""Letters below which a solution's text says too little to be told from other code."""


def squeezed(text: str) -> str:
    """A text without its white space."""
    return re.sub(r"\s+", "", text)


@functools.cache
def solutions() -> list[str]:
    """The text of every solution."""
    sources = []
    for file in sorted(NOTEBOOKS.glob("*.ipynb")):
        for cell in json.loads(file.read_text(encoding="utf-8"))["cells"]:
            sources += [textwrap.dedent(source) for source in _BETWEEN.findall("".join(cell["source"]))]
    return sources


@functools.cache
def _texts() -> list[str]:
    return [text for solution in solutions() if len(text := squeezed(solution)) >= SHORT]


@functools.cache
def _trees() -> frozenset[str]:
    return frozenset(tree for solution in solutions() for tree in trees(solution))


def trees(text: str) -> list[str]:
    """The bodies of the functions in a text as syntax trees, without their docstrings; none where it is no Python."""
    try:
        parsed = ast.parse(text)
    except (SyntaxError, ValueError):
        return []
    defined = [node for node in ast.walk(parsed) if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef))]
    return [dump for node in defined if len(dump := _body(node)) >= 4 * SHORT]


def _body(node: ast.FunctionDef | ast.AsyncFunctionDef) -> str:
    plain = node.body[1:] if ast.get_docstring(node) else node.body
    return "; ".join(ast.dump(statement) for statement in plain)


def found_in(text: str) -> list[str]:
    """What of the solutions stands in a text."""
    cells = [text]
    if text.lstrip().startswith('{\n "cells"'):
        cells = ["".join(cell["source"]) for cell in json.loads(text)["cells"]]
    flat = squeezed("\n".join(cells))
    said = ["a marker"] if MARKER in text else []
    said += [f"the text {solution_text[:60]}" for solution_text in _texts() if solution_text in flat]
    own = {tree for cell in cells for tree in trees(cell)}
    return said + [f"the syntax tree {tree[:60]}" for tree in sorted(own & _trees())]
