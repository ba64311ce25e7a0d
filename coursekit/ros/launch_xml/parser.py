"""The parser of XML launch files."""

from __future__ import annotations

from typing import TextIO
from xml.parsers import expat

from launch import frontend

from .element import read_elements
from .entity import Entity


class Parser(frontend.Parser):
    """Reads XML launch files."""

    @classmethod
    def load(cls, file: str | TextIO) -> tuple[Entity, Parser]:
        """Return the root element and a parser.

        Raises:
            ValueError: if the text is not XML; the message contains file, line and column.
        """
        if isinstance(file, str):
            with open(file, encoding="utf-8") as opened:
                return cls.load(opened)
        name = str(getattr(file, "name", "<text>"))
        try:
            return Entity(read_elements(file.read(), name)), cls()
        except expat.ExpatError as error:
            what = expat.ErrorString(error.code)
            raise ValueError(
                f"{name}:{error.lineno}: not valid XML: {what} (column {error.offset})"
            ) from error

    @classmethod
    def get_file_extensions(cls) -> set[str]:
        """Return the file name extensions of this format."""
        return {"xml"}
