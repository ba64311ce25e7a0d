"""Errors in a world: the file, the location in it, and the remedy."""

from __future__ import annotations

from collections.abc import Iterable

from coursekit.suggestions import did_you_mean


class WorldError(ValueError):
    """A world that cannot be simulated: `what`, its location (`file`, `line`, `element`), and the `cure`.

    >>> print(WorldError("has 2 points", file="a.yaml", line=3, element="polygon 'desk'", cure="Give it three."))
    a.yaml:3: polygon 'desk': has 2 points
    Give it three.
    """

    def __init__(self, what: str, *, file: str = "", line: int = 0, element: str = "", cure: str = "") -> None:
        self.what, self.file, self.line, self.element, self.cure = what, file or "world", line, element, cure
        place = f"{self.file}:{line}" if line else self.file
        parts = [part for part in (place, element, what) if part]
        super().__init__(": ".join(parts) + (f"\n{cure}" if cure else ""))


def known(name: str, names: Iterable[str]) -> str:
    """Return a hint with the most similar of some names, or all of them.

    >>> known("hight", ["height", "name"])
    "Did you mean 'height'?"
    """
    there = sorted(names)
    all_of_them = f"There are: {', '.join(there[:20]) or 'none'}{' ...' if len(there) > 20 else ''}."
    return did_you_mean(str(name), there, all_of_them, quotes="'")


__all__ = ["WorldError", "known"]
