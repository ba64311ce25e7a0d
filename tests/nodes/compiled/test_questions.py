"""What the C++ side asks, the session answers: each question by its name."""

from __future__ import annotations

import re
from pathlib import Path

import coursekit.cpp
from coursekit.nodes.compiled.host import OPERATIONS

ROOM = Path(coursekit.cpp.__file__).parent
_ASKED = re.compile(r'\b(?:ask|asked|request|note)\(\s*"(\w+)"')


def test_every_question_has_an_answer():
    files = [path for path in ROOM.rglob("*") if path.suffix in (".h", ".hpp", ".cpp")]
    asked = {name for path in files for name in _ASKED.findall(path.read_text(encoding="utf-8"))}
    assert len(asked) > 100
    assert asked <= set(OPERATIONS)
