"""Appends to an environment variable."""

from __future__ import annotations

import os
from typing import Any

from ..action import Action
from ..frontend import Entity, Parser, expose_action
from ..launch_context import LaunchContext
from ..launch_description_entity import LaunchDescriptionEntity
from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from ..utilities import normalize_to_list_of_substitutions, perform_substitutions
from ..utilities.type_utils import normalize_typed_substitution, perform_typed_substitution
from .named import NamedValueAction


@expose_action("append_env")
class AppendEnvironmentVariable(NamedValueAction):
    """Appends (or prepends) a value to an environment variable; sets the variable if it is unset."""

    def __init__(
        self,
        name: SomeSubstitutionsType,
        value: SomeSubstitutionsType,
        prepend: bool | SomeSubstitutionsType = False,
        separator: SomeSubstitutionsType = os.pathsep,
        **kwargs: Any,
    ) -> None:
        super().__init__(name, value, **kwargs)
        self.__prepend = normalize_typed_substitution(prepend, bool)
        self.__separator = normalize_to_list_of_substitutions(separator)

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """Read `<append_env name= value= prepend= separator=/>`."""
        _, kwargs = super().parse(entity, parser)
        prepend = entity.get_attr("prepend", data_type=bool, optional=True, can_be_str=True)
        if prepend is not None:
            kwargs["prepend"] = parser.parse_if_substitutions(prepend)
        separator = entity.get_attr("separator", optional=True)
        if separator is not None:
            kwargs["separator"] = parser.parse_substitution(separator)
        return cls, kwargs

    @property
    def prepend(self) -> Any:
        """Whether the new value is put before the old one."""
        return self.__prepend

    @property
    def separator(self) -> list[Substitution]:
        """The text between the old and the new value, as substitutions."""
        return self.__separator

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Append to the variable, or prepend."""
        name = perform_substitutions(context, self.name)
        parts = [perform_substitutions(context, self.value)]
        if name in context.environment:
            prepend = perform_typed_substitution(context, self.__prepend, bool)
            parts.insert(len(parts) if prepend else 0, context.environment[name])
        context.environment[name] = perform_substitutions(context, self.__separator).join(parts)
        return None
