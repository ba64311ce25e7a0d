"""Makes all following nodes take their time from /clock."""

from __future__ import annotations

from typing import Any

from launch.action import Action
from launch.frontend import Entity, Parser, expose_action
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities.type_utils import normalize_typed_substitution

from ..parameter_descriptions import ParameterValue
from .set_parameter import SetParameter


@expose_action("set_use_sim_time")
class SetUseSimTime(SetParameter):
    """Sets use_sim_time of the following nodes in the same group."""

    def __init__(self, value: bool | SomeSubstitutionsType, **kwargs: Any) -> None:
        checked = normalize_typed_substitution(value, bool)
        super().__init__("use_sim_time", ParameterValue(checked, value_type=bool), **kwargs)

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """Read `<set_use_sim_time value=/>`."""
        _, kwargs = Action.parse(entity, parser)
        value = entity.get_attr("value", data_type=bool, can_be_str=True)
        kwargs["value"] = parser.parse_if_substitutions(value)
        return cls, kwargs
