"""A copy of a file in which words are replaced."""

from __future__ import annotations

from typing import TYPE_CHECKING

from launch.condition import Condition
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.temporary_files import temporary_files
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions

from coursekit.files import installed

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class ReplaceString(Substitution):
    """The name of a copy of `source_file` in which every key of `replacements` is replaced by its value.

    If the condition does not hold, it is the name of the file itself.
    """

    def __init__(
        self,
        source_file: SomeSubstitutionsType,
        replacements: dict[str, SomeSubstitutionsType],
        condition: Condition | None = None,
    ) -> None:
        super().__init__()
        self.__source_file = normalize_to_list_of_substitutions(source_file)
        self.__replacements = {key: normalize_to_list_of_substitutions(to) for key, to in replacements.items()}
        self.__condition = condition

    @property
    def name(self) -> list[Substitution]:
        """The file, as substitutions."""
        return self.__source_file

    @property
    def condition(self) -> Condition | None:
        """The condition for replacing words; None for always."""
        return self.__condition

    def describe(self) -> str:
        """Return the substitution in words."""
        return f"ReplaceString({', '.join(sub.describe() for sub in self.__source_file)})"

    def perform(self, context: LaunchContext) -> str:
        """Return the name of the file to use."""
        source = installed(perform_substitutions(context, self.__source_file))
        if self.__condition is not None and not self.__condition.evaluate(context):
            return source
        with open(source, encoding="utf-8") as file:
            text = file.read()
        for key, value in self.__replacements.items():
            text = text.replace(key, perform_substitutions(context, value))
        path = temporary_files.new_path("replaced_")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path
