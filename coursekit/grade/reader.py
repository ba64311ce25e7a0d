"""Inside a sandbox: read a student's files for the judge.

`python -I -m coursekit.grade.reader WORKSPACE`: each JSON line on stdin is answered by one JSON line.
"""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path
from typing import Any

from .reading import READINGS
from .sandbox_facts import as_json
from .verdict import Wrong


def answer(workspace: Path, question: dict[str, Any]) -> str:
    """Return the requested facts, or the fault."""
    try:
        return f'{{"facts": {as_json(READINGS[question.pop("ask")](workspace, **question))}}}'
    except Wrong as wrong:
        return as_json({"wrong": [wrong.expected, wrong.got, wrong.cause]})
    except Exception as error:
        return as_json({"wrong": ["a file that can be read", f"{type(error).__name__}: {error}"[:300], ""]})


def main() -> int:
    """Answer until the judge closes the connection."""
    questions = os.fdopen(os.dup(0), encoding="utf-8")
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    nothing = os.open(os.devnull, os.O_RDWR)
    for number in (0, 1):
        os.dup2(nothing, number)
    workspace = Path(sys.argv[1])
    for line in questions:
        answers.write(answer(workspace, json.loads(line)) + "\n")
        answers.flush()
    os._exit(0)


if __name__ == "__main__":
    sys.exit(main())
