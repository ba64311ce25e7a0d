"""Names that differ in case only: on macOS and Windows they are one file, on a robot's Linux two."""

from __future__ import annotations

from pathlib import Path


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


__all__ = ["other_spelling"]
