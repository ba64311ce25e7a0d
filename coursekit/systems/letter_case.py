"""Names that differ only in case: the same file on macOS and Windows, the same variable on Windows, two on Linux."""

from __future__ import annotations

from pathlib import Path

from . import operating_system


def other_spelling(path: Path) -> str:
    """Return the actual name in the folder if it differs from `path` only in case and names the same file here; else ''.

    >>> other_spelling(Path("/nowhere/at/all"))
    ''
    """
    try:
        if not path.exists():
            return ""
        names = [entry.name for entry in path.parent.iterdir()]
    except OSError:
        return ""
    if path.name in names:
        return ""
    return next((name for name in names if name.casefold() == path.name.casefold()), "")


def variable_name(name: str) -> str:
    """Return a variable's name as stored here: on Windows `Path`, `path` and `PATH` are the same, in capitals.

    >>> variable_name("PATH")
    'PATH'
    """
    return name.upper() if operating_system.WINDOWS else name


__all__ = ["other_spelling", "variable_name"]
