"""The description of a node that is loaded into a container."""

from __future__ import annotations

from typing import Any

from launch.condition import Condition
from launch.frontend import Entity, Parser
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities import normalize_to_list_of_substitutions

from ..parameters_type import Parameters, SomeParameters
from ..remap_rule_type import RemapRules, SomeRemapRules
from ..utilities import normalize_parameters, normalize_remap_rules
from ..utilities.parse_composable_node import parse_composable_node


class ComposableNode:
    """A component: package, plugin (such as 'image_proc::RectifyNode'), and settings as for a Node."""

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
        self.__node_plugin = normalize_to_list_of_substitutions(plugin)
        self.__node_name = None if name is None else normalize_to_list_of_substitutions(name)
        self.__node_namespace = None if namespace is None else normalize_to_list_of_substitutions(namespace)
        self.__parameters = None if parameters is None else normalize_parameters(parameters)
        self.__remappings = list(normalize_remap_rules(remappings)) if remappings else None
        self.__extra_arguments = normalize_parameters(extra_arguments) if extra_arguments else None
        self.__condition = condition

    @classmethod
    def parse(cls, parser: Parser, entity: Entity) -> tuple[type[ComposableNode], dict[str, Any]]:
        """Read `<composable_node pkg= plugin= name= namespace=>` with param, remap and extra_arg inside."""
        return cls, parse_composable_node(entity, parser)

    @property
    def package(self) -> list[Substitution]:
        """The package, as substitutions."""
        return self.__package

    @property
    def node_plugin(self) -> list[Substitution]:
        """The plugin, as substitutions."""
        return self.__node_plugin

    @property
    def node_name(self) -> list[Substitution] | None:
        """The node's name, as substitutions."""
        return self.__node_name

    @property
    def node_namespace(self) -> list[Substitution] | None:
        """The node's namespace, as substitutions."""
        return self.__node_namespace

    @property
    def parameters(self) -> Parameters | None:
        """Files and mappings, with their substitutions not yet performed."""
        return self.__parameters

    @property
    def remappings(self) -> RemapRules | None:
        """The (from, to) pairs, as substitutions."""
        return self.__remappings

    @property
    def extra_arguments(self) -> Parameters | None:
        """The container's options, for example use_intra_process_comms; they have no effect here."""
        return self.__extra_arguments

    def condition(self) -> Condition | None:
        """The condition for loading the component."""
        return self.__condition
