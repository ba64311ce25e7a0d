"""Remaps a name for all following nodes."""

from __future__ import annotations

from typing import Any

from launch.action import Action
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions


@expose_action("set_remap")
class SetRemap(Action):
    """Adds a remapping to the following nodes in the same group."""

    def __init__(self, src: SomeSubstitutionsType, dst: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__src = normalize_to_list_of_substitutions(src)
        self.__dst = normalize_to_list_of_substitutions(dst)

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """Read `<set_remap from= to=/>`."""
        _, kwargs = super().parse(entity, parser)
        kwargs["src"] = parser.parse_substitution(entity.get_attr("from"))
        kwargs["dst"] = parser.parse_substitution(entity.get_attr("to"))
        return cls, kwargs

    @property
    def src(self) -> list[Substitution]:
        """The name that is remapped, as substitutions."""
        return self.__src

    @property
    def dst(self) -> list[Substitution]:
        """The new name, as substitutions."""
        return self.__dst

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Add the remapping."""
        configurations: dict[str, Any] = context.launch_configurations
        pair = perform_substitutions(context, self.__src), perform_substitutions(context, self.__dst)
        configurations["ros_remaps"] = [*configurations.get("ros_remaps", []), pair]
        return None
