"""The description of a node that is loaded into a container."""

from __future__ import annotations

from typing import Any

from launch.condition import Condition
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities import normalize_to_list_of_substitutions

from ..parameters_type import SomeParameters
from ..remap_rule_type import SomeRemapRules


class ComposableNode:
    """A component: package, plugin (such as 'image_proc::RectifyNode') and what a Node takes."""

    def __init__(
        self,
        *,
        package: SomeSubstitutionsType,
        plugin: SomeSubstitutionsType,
        name: SomeSubstitutionsType | None = None,
        namespace: SomeSubstitutionsType | None = None,
        parameters: SomeParameters | None = None,
        remappings: SomeRemapRules | None = None,
        extra_arguments: SomeParameters | None = None,
        condition: Condition | None = None,
    ) -> None:
        self.__package = normalize_to_list_of_substitutions(package)
        self.__plugin = normalize_to_list_of_substitutions(plugin)
        self.__given: dict[str, Any] = {
            "name": name,
            "namespace": namespace,
            "parameters": parameters,
            "remappings": remappings,
        }
        self.__extra_arguments = extra_arguments
        self.__condition = condition

    @property
    def package(self) -> list[Substitution]:
        """The package, as substitutions."""
        return self.__package

    @property
    def node_plugin(self) -> list[Substitution]:
        """The plugin, as substitutions."""
        return self.__plugin

    @property
    def extra_arguments(self) -> SomeParameters | None:
        """What the container is told, for example use_intra_process_comms; it makes no difference here."""
        return self.__extra_arguments

    @property
    def node_arguments(self) -> dict[str, Any]:
        """What a Node action gets: name, namespace, parameters and remappings, where given."""
        return {key: value for key, value in self.__given.items() if value is not None}

    def condition(self) -> Condition | None:
        """The condition under which it is loaded."""
        return self.__condition
