"""Unsets an environment variable."""

from __future__ import annotations

from typing import Any

from ..action import Action
from ..frontend import Entity, Parser, expose_action
from ..launch_context import LaunchContext
from ..launch_description_entity import LaunchDescriptionEntity
from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from ..utilities import normalize_to_list_of_substitutions, perform_substitutions


@expose_action("unset_env")
class UnsetEnvironmentVariable(Action):
    """Takes an environment variable away; harmless when it is not set."""

    def __init__(self, name: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__name = normalize_to_list_of_substitutions(name)

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """Read `<unset_env name=/>`."""
        _, kwargs = super().parse(entity, parser)
        kwargs["name"] = parser.parse_substitution(entity.get_attr("name"))
        return cls, kwargs

    @property
    def name(self) -> list[Substitution]:
        """The name, as substitutions."""
        return self.__name

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Unset the variable."""
        name = perform_substitutions(context, self.__name)
        if name in context.environment:
            del context.environment[name]
        return None
