"""The text of a file."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ..frontend.expose import expose_substitution
from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from ..utilities import normalize_to_list_of_substitutions, perform_substitutions
from .substitution_failure import SubstitutionFailure

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


@expose_substitution("file-content")
class FileContent(Substitution):
    """The whole text of a file, read when the launch file runs."""

    def __init__(self, path: SomeSubstitutionsType) -> None:
        super().__init__()
        self.__path = normalize_to_list_of_substitutions(path)

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[Substitution], dict[str, Any]]:
        """Read `$(file-content path)`."""
        if len(data) != 1:
            raise TypeError("file-content substitution expects 1 argument")
        return cls, {"path": data[0]}

    @property
    def path(self) -> list[Substitution]:
        """The path, as substitutions."""
        return self.__path

    def describe(self) -> str:
        """Return a description of the path."""
        return f"FileContent({' + '.join(sub.describe() for sub in self.__path)})"

    def perform(self, context: LaunchContext) -> str:
        """Return the file's text.

        Raises:
            SubstitutionFailure: if it cannot be read.
        """
        path = perform_substitutions(context, self.__path)
        try:
            with open(path, encoding="utf-8") as file:
                return file.read()
        except OSError as error:
            raise SubstitutionFailure(f"Failed to read file '{path}': {error.strerror}") from error
