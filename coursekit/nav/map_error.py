"""Errors in a map file: the file, the fault, and the remedy."""

from __future__ import annotations


class MapError(ValueError):
    """A map that cannot be read or written; `part` is 'metadata' for the description and 'picture' for the image.

    >>> print(MapError("room.yaml", "resolution is -1", "it is metres a cell, for example 0.05"))
    room.yaml: resolution is -1
    it is metres a cell, for example 0.05
    """

    def __init__(self, file: str, what: str, cure: str, *, part: str = "metadata") -> None:
        self.file, self.what, self.cure, self.part = file, what, cure, part
        super().__init__(f"{file}: {what}\n{cure}")
