"""Checks that source files start with a copyright notice."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

_SUFFIXES = (".py", ".c", ".cc", ".cpp", ".cxx", ".h", ".hh", ".hpp", ".hxx", ".cmake")
_HEAD_LINES = 20


def main(argv: Sequence[str] | None = None) -> int:
    """Return 0 when every source file below the folders has a notice, else 1 after naming the others."""
    words = [one for one in (sys.argv[1:] if argv is None else argv) if not one.startswith("-")]
    files = {one for word in words or ["."] for one in _sources(Path(word))}
    bad = [path for path in sorted(files) if not _has_notice(path)]
    for path in bad:
        print(f"{path}: could not find copyright notice", file=sys.stderr)
    counted = f"checked {len(files)} files"
    print(f"{len(bad)} errors, {counted}" if bad else f"No errors, {counted}")
    return 1 if bad else 0


def _sources(path: Path) -> Iterator[Path]:
    """The sources below a folder, or the file itself; not what is generated, hidden or ignored, nor a package's setup.py."""
    if path.is_file():
        yield path
        return
    for place, folders, files in os.walk(path):
        if "AMENT_IGNORE" in (*folders, *files):
            folders.clear()
            continue
        folders[:] = [one for one in folders if one[0] not in "._"]
        left_out = {"setup.py"} if "package.xml" in files else set()
        yield from (Path(place, one) for one in set(files) - left_out if Path(one).suffix in _SUFFIXES)


def _has_notice(path: Path) -> bool:
    lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
    return not "".join(lines).strip() or any("copyright" in line.lower() for line in lines[:_HEAD_LINES])
