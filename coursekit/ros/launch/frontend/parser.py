"""Converts elements of XML and YAML launch files to actions."""

from __future__ import annotations

import importlib
import importlib.metadata
import io
import os
import traceback
import warnings
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, TextIO

from ..invalid_launch_file_error import InvalidLaunchFileError
from ..substitution import Substitution
from .entity import Entity
from .expose import instantiate_action
from .parse_substitution import parse_if_substitutions, parse_substitution, replace_escaped_characters

if TYPE_CHECKING:
    from ..action import Action
    from ..launch_description import LaunchDescription

EXTENSION_MODULES = (
    "launch.actions",
    "launch.substitutions",
    "launch_ros.actions",
    "launch_ros.substitutions",
)
EXTENSIONS = "launch.frontend.launch_extension"
IMPLEMENTATIONS = "launch.frontend.parser"
PARSERS = {
    "xml": ("launch_xml", "Parser"),
    "yaml": ("launch_yaml", "Parser"),
    "yml": ("launch_yaml", "Parser"),
}


class InvalidFrontendLaunchFileError(InvalidLaunchFileError):
    """Raised for an invalid XML or YAML launch file."""


class Parser:
    """Reads launch files; each format has a subclass with its own `load`."""

    extensions_loaded = False
    frontend_parsers: dict[str, type[Parser]] | None = None

    @classmethod
    def load_launch_extensions(cls) -> None:
        """Import the modules that expose actions and substitutions: built-in modules and those of installed packages."""
        if cls.extensions_loaded:
            return
        cls.extensions_loaded = True
        for module in EXTENSION_MODULES:
            importlib.import_module(module)
        for _ in _installed(EXTENSIONS, "launch extension"):
            pass

    @classmethod
    def load_parser_implementations(cls) -> None:
        """Import the parsers: built-in parsers and those of installed packages."""
        if cls.frontend_parsers is None:
            ours = {
                name: getattr(importlib.import_module(module), parser)
                for name, (module, parser) in PARSERS.items()
                if name != "yml"
            }
            cls.frontend_parsers = {**dict(_installed(IMPLEMENTATIONS, "parser implementation")), **ours}

    @classmethod
    def get_available_extensions(cls) -> list[str]:
        """Return the supported file name extensions.

        >>> Parser.get_available_extensions()
        ['xml', 'yaml', 'yml']
        """
        return list(PARSERS)

    @classmethod
    def is_extension_valid(cls, extension: str) -> bool:
        """Return whether files with this extension can be read."""
        return extension in PARSERS

    @classmethod
    def get_parser_from_extension(cls, extension: str) -> type[Parser]:
        """Return the parser for a file name extension.

        Raises:
            RuntimeError: if there is none.
        """
        if extension not in PARSERS:
            raise RuntimeError(
                f"Not recognized frontend implementation: {extension} (known: {', '.join(PARSERS)})"
            )
        module, name = PARSERS[extension]
        parser: type[Parser] = getattr(importlib.import_module(module), name)
        return parser

    @classmethod
    def get_file_extensions_from_parsers(cls) -> list[str]:
        """Return the supported file name extensions."""
        return cls.get_available_extensions()

    @classmethod
    def load(cls, file: str | TextIO) -> tuple[Entity, Parser]:
        """Return the root element of a file and the matching parser.

        Raises:
            InvalidFrontendLaunchFileError: if no parser can read it.
        """
        if isinstance(file, (str, os.PathLike)):
            with open(file, encoding="utf-8") as opened:
                return cls._load_text(opened.read(), str(file))
        return cls._load_text(file.read(), getattr(file, "name", ""))

    @classmethod
    def _load_text(cls, text: str, name: str) -> tuple[Entity, Parser]:
        ending = os.path.splitext(str(name))[1][1:]
        endings = [ending] if ending in PARSERS else ["xml", "yaml"]
        errors: list[BaseException] = []
        for candidate in endings:
            stream = io.StringIO(text)
            stream.name = name
            try:
                return cls.get_parser_from_extension(candidate).load(stream)
            except Exception as error:
                errors.append(error)
        raise InvalidFrontendLaunchFileError(
            ending if ending in PARSERS else "", likely_errors=errors
        ) from errors[0]

    def parse_action(self, entity: Entity) -> Action:
        """Return the action for an element; an error message names the file, line and element."""
        self.load_launch_extensions()
        try:
            return instantiate_action(entity, self)
        except ElementError:
            raise
        except Exception as error:
            raise ElementError(entity, error) from error

    def parse_substitution(self, value: str) -> list[Substitution]:
        """Parse text into a list of substitutions."""
        self.load_launch_extensions()
        return parse_substitution(value)

    def parse_if_substitutions(self, value: Any) -> Any:
        """Return `value` with the text in it parsed; text without substitutions stays text."""
        self.load_launch_extensions()
        return parse_if_substitutions(value)

    def escape_characters(self, value: str) -> str:
        """Return text with its backslashes resolved."""
        return replace_escaped_characters(value)

    def parse_description(self, entity: Entity) -> LaunchDescription:
        """Return the launch description of a root element.

        Raises:
            RuntimeError: if the root is not called launch.
        """
        from ..launch_description import LaunchDescription

        if entity.type_name != "launch":
            raise ElementError(
                entity, RuntimeError(f"Expected 'launch' as root tag, got '{entity.type_name}'")
            )
        reason = entity.get_attr("deprecated", optional=True)
        entity.get_attr("version", optional=True)
        actions = [self.parse_action(child) for child in entity.children]
        return LaunchDescription(actions, deprecated_reason=reason)


class ElementError(RuntimeError, ValueError, TypeError, AttributeError):
    """Raised for an invalid element; the message names the file and line.

    It can be caught as any of the errors that elements raise.
    """

    def __init__(self, entity: Entity, error: BaseException) -> None:
        self.entity = entity
        place = f"{entity.place}: " if entity.place else ""
        super().__init__(f"{place}in <{entity.type_name}>: {error}")


def _installed(group: str, what: str) -> Iterator[tuple[str, Any]]:
    """Yield the name and the object of each entry point of a group; warn about those that fail."""
    entry_points: Any = importlib.metadata.entry_points()
    for entry_point in entry_points.select(group=group) if hasattr(entry_points, "select") else entry_points.get(group, []):
        try:
            yield entry_point.name, entry_point.load()
        except Exception:
            warnings.warn(f"Failed to load the {what}: {entry_point.name}\n{traceback.format_exc()}", stacklevel=3)
