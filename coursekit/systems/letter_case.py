"""Names that differ in case only: files on macOS and Windows, variables on Windows are one, on a robot's Linux two."""

from __future__ import annotations

from pathlib import Path

from . import which


def other_spelling(path: Path) -> str:
    """The name in its folder that is `path`'s but for its case, where this system takes the two for one; else empty.

    >>> other_spelling(Path("/nowhere/at/all"))
    ''
    """
    try:
        if not path.exists():
            return ""
        names = [one.name for one in path.parent.iterdir()]
    except OSError:
        return ""
    if path.name in names:
        return ""
    return next((name for name in names if name.casefold() == path.name.casefold()), "")


def variable_name(name: str) -> str:
    """How a variable of the environment is kept here: on Windows `Path`, `path` and `PATH` are one, in capitals.

    >>> variable_name("PATH")
    'PATH'
    """
    return name.upper() if which.WINDOWS else name


__all__ = ["other_spelling", "variable_name"]
