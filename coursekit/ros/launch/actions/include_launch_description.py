"""Includes another launch file."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import Any

from ..action import Action
from ..frontend import Entity, Parser, expose_action
from ..launch_context import LaunchContext
from ..launch_description import LaunchDescription
from ..launch_description_entity import LaunchDescriptionEntity
from ..launch_description_source import LaunchDescriptionSource
from ..some_substitutions_type import SomeSubstitutionsType
from ..utilities import normalize_to_list_of_substitutions, perform_substitutions
from .declare_launch_argument import DeclareLaunchArgument
from .set_launch_configuration import SetLaunchConfiguration

LOCATION_LOCALS = ("current_launch_file_path", "current_launch_file_directory")


@expose_action("include")
class IncludeLaunchDescription(Action):
    """Visits the entities of another launch description, with arguments for it.

    As in ROS 2, the arguments and the settings of the included file remain set afterwards. To limit them, put
    the include into a GroupAction.
    """

    def __init__(
        self,
        launch_description_source: LaunchDescriptionSource | SomeSubstitutionsType | LaunchDescription,
        *,
        launch_arguments: Iterable[tuple[SomeSubstitutionsType, SomeSubstitutionsType]] | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        if isinstance(launch_description_source, LaunchDescription):
            launch_description_source = LaunchDescriptionSource(launch_description_source)
        elif not isinstance(launch_description_source, LaunchDescriptionSource):
            from ..launch_description_sources import AnyLaunchDescriptionSource

            launch_description_source = AnyLaunchDescriptionSource(launch_description_source)
        self.__source = launch_description_source
        self.__arguments = tuple(launch_arguments) if launch_arguments is not None else ()
        self.__before: dict[str, Any] | None = None

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """Read `<include file=><arg name= value=/></include>`."""
        _, kwargs = super().parse(entity, parser)
        kwargs["launch_description_source"] = parser.parse_substitution(entity.get_attr("file"))
        arguments = entity.get_attr("arg", data_type=list[Entity], optional=True)
        arguments = (arguments or []) + (entity.get_attr("let", data_type=list[Entity], optional=True) or [])
        pairs = [
            (
                parser.parse_substitution(item.get_attr("name")),
                parser.parse_substitution(item.get_attr("value")),
            )
            for item in arguments
        ]
        for item in arguments:
            item.assert_entity_completely_parsed()
        if pairs:
            kwargs["launch_arguments"] = pairs
        return cls, kwargs

    @property
    def launch_description_source(self) -> LaunchDescriptionSource:
        """The source of the description."""
        return self.__source

    @property
    def launch_arguments(self) -> tuple[tuple[SomeSubstitutionsType, SomeSubstitutionsType], ...]:
        """The arguments, as (name, value)."""
        return self.__arguments

    def describe(self) -> str:
        """Return the location of the included description."""
        return f"IncludeLaunchDescription({self.__source.describe_location()})"

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the included description if it is available before launching."""
        description = self.__source.try_get_launch_description_without_context()
        return [description] if description is not None else []

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Return the settings of the arguments, then the description; set the locals to its location.

        Raises:
            RuntimeError: if an argument that the included description requires is missing.
        """
        description = self.__source.get_launch_description(context)
        self.__before = {name: context.get_locals_as_dict().get(name) for name in LOCATION_LOCALS}
        self.__check_arguments(context, description)
        context.extend_locals(dict(zip(LOCATION_LOCALS, self.__location(), strict=True)))
        settings = [SetLaunchConfiguration(name, value) for name, value in self.__arguments]
        return [*settings, description]

    def leave(self, context: LaunchContext) -> None:
        """Reset the locals: the entities that follow are those of the including file again."""
        if self.__before is not None:
            context.extend_locals(self.__before)
            self.__before = None

    def __location(self) -> tuple[str, str]:
        """Return the path and the folder of the included description; a location that is not a file stays unchanged."""
        location = str(self.__source.location)
        if location.startswith("<"):
            return location, location
        path = os.path.abspath(location)
        return path, os.path.dirname(path)

    def __check_arguments(self, context: LaunchContext, description: LaunchDescription) -> None:
        given = [
            perform_substitutions(context, normalize_to_list_of_substitutions(name))
            for name, _ in self.__arguments
        ]
        declared = description.get_launch_arguments_with_include_launch_description_actions()
        for argument, includes in declared:
            if argument._conditionally_included or argument.default_value is not None:
                continue
            if argument.name in given or argument.name in _given_by(context, includes or []):
                continue
            raise RuntimeError(_missing(argument, given))


def _given_by(context: LaunchContext, includes: list[IncludeLaunchDescription]) -> list[str]:
    pairs = [pair for include in includes for pair in include.launch_arguments]
    return [perform_substitutions(context, normalize_to_list_of_substitutions(name)) for name, _ in pairs]


def _missing(argument: DeclareLaunchArgument, given: list[str]) -> str:
    return (
        f"Included launch description missing required argument '{argument.name}' "
        f"(description: '{argument.description}'), given: [{', '.join(given)}]"
    )
