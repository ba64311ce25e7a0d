"""Replaces all launch configurations."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..action import Action
from ..frontend import Entity, Parser, expose_action
from ..launch_context import LaunchContext
from ..launch_description_entity import LaunchDescriptionEntity
from ..some_substitutions_type import SomeSubstitutionsType
from ..utilities import normalize_to_list_of_substitutions, perform_substitutions


@expose_action("reset")
class ResetLaunchConfigurations(Action):
    """Clears all launch configurations, then sets the given ones; their values may refer to the old ones."""

    def __init__(
        self,
        launch_configurations: Mapping[Any, SomeSubstitutionsType] | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__configurations = dict(launch_configurations or {})

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """Read `<reset><keep name= value=/></reset>`."""
        _, kwargs = super().parse(entity, parser)
        keeps = entity.get_attr("keep", data_type=list[Entity], optional=True) or []
        kwargs["launch_configurations"] = {
            tuple(parser.parse_substitution(keep.get_attr("name"))): parser.parse_substitution(
                keep.get_attr("value")
            )
            for keep in keeps
        }
        return cls, kwargs

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Replace the configurations."""
        kept = {}
        for name, value in self.__configurations.items():
            key = perform_substitutions(context, normalize_to_list_of_substitutions(name))
            kept[key] = perform_substitutions(context, normalize_to_list_of_substitutions(value))
        context._reset_launch_configurations(kept)
        return None
