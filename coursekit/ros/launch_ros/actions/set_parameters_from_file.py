"""Sets parameters of all following nodes from a file."""

from __future__ import annotations

from typing import Any

from launch.action import Action
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions


@expose_action("set_parameters_from_file")
class SetParametersFromFile(Action):
    """Passes a parameter file to the following nodes in the same group."""

    def __init__(
        self,
        filename: SomeSubstitutionsType,
        *,
        node_name: SomeSubstitutionsType | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__file = normalize_to_list_of_substitutions(filename)
        self.__node_name = node_name

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """Read `<set_parameters_from_file filename=/>`."""
        _, kwargs = super().parse(entity, parser)
        kwargs["filename"] = parser.parse_substitution(entity.get_attr("filename"))
        node_name = entity.get_attr("node-name", optional=True)
        if node_name is not None:
            kwargs["node_name"] = parser.parse_substitution(node_name)
        return cls, kwargs

    @property
    def node_name(self) -> SomeSubstitutionsType | None:
        """The node that the file is for; not used, because the names in the file decide."""
        return self.__node_name

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Add the file; the following nodes check that it exists."""
        path = perform_substitutions(context, self.__file)
        configurations: dict[str, Any] = context.launch_configurations
        configurations["global_params"] = [*configurations.get("global_params", []), path]
        return None
