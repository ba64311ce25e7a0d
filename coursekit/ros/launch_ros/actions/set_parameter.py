"""Sets a parameter of all following nodes."""

from __future__ import annotations

from typing import Any

from launch.action import Action
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities import normalize_to_list_of_substitutions

from ..utilities import evaluate_parameter_dict, normalize_parameter_dict


@expose_action("set_parameter")
class SetParameter(Action):
    """Sets a parameter of the following nodes in the same group; a node's own settings take precedence."""

    def __init__(self, name: SomeSubstitutionsType, value: Any, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__name = normalize_to_list_of_substitutions(name)
        self.__given = normalize_parameter_dict({tuple(self.__name): value})

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """Read `<set_parameter name= value=/>`."""
        _, kwargs = super().parse(entity, parser)
        kwargs["name"] = parser.parse_substitution(entity.get_attr("name"))
        value = entity.get_attr("value", data_type=None)
        kwargs["value"] = parser.parse_substitution(value) if isinstance(value, str) else value
        return cls, kwargs

    @property
    def name(self) -> list[Substitution]:
        """The name, as substitutions."""
        return self.__name

    @property
    def value(self) -> Any:
        """The value, normalized."""
        return next(iter(self.__given.values()))

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Set the parameter."""
        configurations: dict[str, Any] = context.launch_configurations
        given = evaluate_parameter_dict(context, self.__given).items()
        configurations["global_params"] = [*configurations.get("global_params", []), *given]
        return None
