"""The parser of YAML launch files."""

from __future__ import annotations

from typing import TextIO

import yaml
from launch import frontend

from .entity import Entity
from .loader import read_yaml


class Parser(frontend.Parser):
    """Reads YAML launch files."""

    @classmethod
    def load(cls, file: str | TextIO) -> tuple[Entity, Parser]:
        """Return the root element and a parser.

        Raises:
            ValueError: if the text is not YAML, or its root is not one element.
        """
        if isinstance(file, str):
            with open(file, encoding="utf-8") as opened:
                return cls.load(opened)
        name = str(getattr(file, "name", "<text>"))
        try:
            tree = read_yaml(file.read())
        except yaml.YAMLError as error:
            raise ValueError(f"{name}: not valid YAML: {error}") from error
        if not isinstance(tree, dict) or len(tree) != 1:
            raise ValueError(
                f"{name}:1: a YAML launch file is one mapping, 'launch:' and a list of actions below it"
            )
        return Entity(tree, file_name=name), cls()

    @classmethod
    def get_file_extensions(cls) -> set[str]:
        """Return the file name extensions of this format."""
        return {"yaml", "yml"}
