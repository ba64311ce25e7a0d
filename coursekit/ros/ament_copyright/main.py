"""Checks that source files start with a copyright notice."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

_SUFFIXES = (".py", ".c", ".cc", ".cpp", ".cxx", ".h", ".hh", ".hpp", ".hxx", ".cmake")
_HEAD_LINES = 20


def main(argv: Sequence[str] | None = None) -> int:
    """Return 0 when every source file below the folders has a notice, else 1 after naming the others."""
    folders = [Path(a) for a in (sys.argv[1:] if argv is None else argv) if not a.startswith("-")] or [
        Path(".")
    ]
    files = {path for folder in folders for path in folder.rglob("*") if path.suffix in _SUFFIXES}
    bad = [path for path in sorted(files) if not _has_notice(path)]
    for path in bad:
        print(f"{path}: could not find copyright notice", file=sys.stderr)
    print(
        f"{len(bad)} errors, checked {len(files)} files" if bad else f"No errors, checked {len(files)} files"
    )
    return 1 if bad else 0


def _has_notice(path: Path) -> bool:
    lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
    return not "".join(lines).strip() or any("copyright" in line.lower() for line in lines[:_HEAD_LINES])
