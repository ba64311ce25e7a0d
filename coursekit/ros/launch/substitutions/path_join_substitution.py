"""Substitutions that join the parts of a path or text."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import TYPE_CHECKING

from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from ..utilities import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class Extensible(Substitution):
    """A path that `/` extends, as in pathlib."""

    def __truediv__(self, part: SomeSubstitutionsType) -> PathJoinSubstitution:
        return PathJoinSubstitution([self, part])


class PathJoinSubstitution(Extensible):
    """A path joined from parts; each may be text, a substitution, or a list of both.

    >>> from launch import LaunchContext
    >>> path = PathJoinSubstitution(['a', ['b', '.yaml']]).perform(LaunchContext())
    >>> path == os.path.join('a', 'b.yaml')
    True
    """

    def __init__(self, substitutions: Iterable[SomeSubstitutionsType]) -> None:
        super().__init__()
        self.__parts = [normalize_to_list_of_substitutions(part) for part in substitutions]

    @property
    def substitutions(self) -> list[list[Substitution]]:
        """The parts, each a list of substitutions."""
        return self.__parts

    def describe(self) -> str:
        """Return a description of the parts."""
        parts = [" + ".join(sub.describe() for sub in part) for part in self.__parts]
        return f"PathJoin({', '.join(parts)})"

    def perform(self, context: LaunchContext) -> str:
        """Return the joined path."""
        parts = [perform_substitutions(context, part) for part in self.__parts]
        return os.path.join(*parts) if parts else ""

    def __truediv__(self, part: SomeSubstitutionsType) -> PathJoinSubstitution:
        return PathJoinSubstitution([*self.__parts, part])


class PathSubstitution(PathJoinSubstitution):
    """The beginning of a path that `/` extends.

    >>> from launch import LaunchContext
    >>> path = (PathSubstitution('a') / 'b' / 'c.yaml').perform(LaunchContext())
    >>> path == os.path.join('a', 'b', 'c.yaml')
    True
    """

    def __init__(self, path: SomeSubstitutionsType) -> None:
        super().__init__(normalize_to_list_of_substitutions(path))


class StringJoinSubstitution(Substitution):
    """Texts joined with a delimiter."""

    def __init__(
        self, substitutions: Iterable[SomeSubstitutionsType], delimiter: SomeSubstitutionsType = ""
    ) -> None:
        super().__init__()
        self.__parts = [normalize_to_list_of_substitutions(part) for part in substitutions]
        self.__delimiter = normalize_to_list_of_substitutions(delimiter)

    def describe(self) -> str:
        """Return a description of the parts."""
        parts = [" + ".join(sub.describe() for sub in part) for part in self.__parts]
        return f"StringJoin({', '.join(parts)})"

    def perform(self, context: LaunchContext) -> str:
        """Return the joined text."""
        delimiter = perform_substitutions(context, self.__delimiter)
        return delimiter.join(perform_substitutions(context, part) for part in self.__parts)
