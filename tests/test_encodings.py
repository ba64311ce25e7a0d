"""Files, and what children say, are read and written as UTF-8 whatever the computer's code page is: each call says so.

ruff's PLW1514 sees files whose kind it can tell; this sees the rest, and children.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
_CHILDREN = ("run", "Popen", "check_output", "call", "check_call")
_FILES = {"read_text": 0, "write_text": 1}
"""Methods of paths, and the place at which they take an encoding."""


def unsaid(source: str) -> Iterator[int]:
    """The lines of a program that leave the encoding of a file or a child to the computer."""
    for call in (node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Call)):
        given = {keyword.arg: keyword.value for keyword in call.keywords}
        name = call.func.attr if isinstance(call.func, ast.Attribute) else getattr(call.func, "id", "")
        if "encoding" in given or None in given:
            continue
        if isinstance(call.func, ast.Attribute) and name in _FILES and not _is_of_others(call):
            if len(call.args) <= _FILES[name]:
                yield call.lineno
            continue
        file = name in ("open", "fdopen") and _is_text(call, given)
        if file or (name in _CHILDREN and {"text", "universal_newlines"} & set(given)):
            yield call.lineno


def _is_of_others(call: ast.Call) -> bool:
    """Whether it is a function of the module `files`, which knows no other encoding than UTF-8."""
    owner = call.func.value if isinstance(call.func, ast.Attribute) else None
    return isinstance(owner, ast.Name) and owner.id == "files"


def _is_text(call: ast.Call, given: dict[str | None, ast.expr]) -> bool:
    plain = isinstance(call.func, ast.Name) or (isinstance(call.func.value, ast.Name) and call.func.value.id in ("io", "os"))
    mode = given.get("mode", call.args[1] if len(call.args) > 1 else ast.Constant("r"))
    return plain and isinstance(mode, ast.Constant) and isinstance(mode.value, str) and "b" not in mode.value


def test_every_call_is_seen_that_leaves_the_encoding_open() -> None:
    for line in ("p.read_text()", "p.write_text('a')", "open('a')", "os.fdopen(1, 'w')", "run([], text=True)"):
        assert list(unsaid(line)) == [1], line
    for line in ("p.read_text('utf-8')", "open('a', 'rb')", "open('a', encoding='utf-8')", "os.open(p, 1)", "run([])"):
        assert not list(unsaid(line)), line


def test_all_programs_of_the_course_say_the_encoding_of_their_files_and_children() -> None:
    places = [
        f"{file.relative_to(ROOT)}:{line}"
        for file in sorted((ROOT / "coursekit").rglob("*.py"))
        for line in unsaid(file.read_text(encoding="utf-8"))
    ]
    assert not places, "say encoding='utf-8' in:\n" + "\n".join(places)
