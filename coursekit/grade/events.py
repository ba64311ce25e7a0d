"""The event log of a course folder; each line contains the digest of the line before."""

from __future__ import annotations

import hashlib
import json
import time
from collections.abc import Iterable
from pathlib import Path
from typing import Any

BEGINNING = "0" * 64


def note(file: Path, event: str, **facts: Any) -> None:
    """Add a line; a failure to write must not stop a student's work."""
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        lines = file.read_text(encoding="utf-8").splitlines() if file.exists() else []
        before = str(json.loads(lines[-1])["digest"]) if lines else BEGINNING
        entry = {"event": event, "time": round(time.time(), 3), **facts, "before": before}
        with open(file, "a", encoding="utf-8") as out:
            out.write(json.dumps({**entry, "digest": digest(entry)}, sort_keys=True) + "\n")
    except (OSError, ValueError, LookupError, TypeError):
        pass


def digest(line: dict[str, Any]) -> str:
    """Return the digest of a line without its digest field.

    >>> digest({"event": "check"})[:8]
    'a13023b2'
    """
    return hashlib.sha256(json.dumps(line, sort_keys=True).encode()).hexdigest()


def faults(lines: Iterable[str]) -> list[str]:
    """Return the breaks in the chain.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder, "events.jsonl")
    ...     note(file, "check", name="relay"); note(file, "check", name="lift")
    ...     lines = file.read_text(encoding="utf-8").splitlines()
    >>> faults(lines), len(faults(lines[1:]))  # the first line was removed
    ([], 1)
    """
    before = BEGINNING
    for number, text in enumerate(lines, 1):
        try:
            line = json.loads(text)
            said = line.pop("digest")
        except (ValueError, AttributeError, KeyError, TypeError, RecursionError):
            return [f"events.jsonl: line {number} cannot be read"]
        if line.get("before") != before:
            return [f"events.jsonl: line {number} does not follow the one before it"]
        if digest(line) != said:
            return [f"events.jsonl: line {number} was changed"]
        before = said
    return []
