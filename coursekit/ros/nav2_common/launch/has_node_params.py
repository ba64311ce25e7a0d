"""Whether a parameter file has an entry for a node."""

from __future__ import annotations

from typing import TYPE_CHECKING

import yaml
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions

from coursekit.files import installed

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class HasNodeParams(Substitution):
    """The text `True` if the file has a top-level entry with the node's name, else `False`."""

    def __init__(self, source_file: SomeSubstitutionsType, node_name: str) -> None:
        super().__init__()
        self.__source_file = normalize_to_list_of_substitutions(source_file)
        self.__node_name = node_name

    @property
    def name(self) -> list[Substitution]:
        """The file, as substitutions."""
        return self.__source_file

    def describe(self) -> str:
        """Return the substitution in words."""
        return f"HasNodeParams({self.__node_name})"

    def perform(self, context: LaunchContext) -> str:
        """Return `True` or `False`."""
        with open(installed(perform_substitutions(context, self.__source_file)), encoding="utf-8") as file:
            return str(self.__node_name in (yaml.safe_load(file) or {}))
