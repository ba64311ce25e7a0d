"""Declares an argument of a launch file."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from ..action import Action
from ..frontend import Entity, Parser, expose_action
from ..launch_context import LaunchContext
from ..logging import get_logger
from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from ..utilities import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from ..launch_description_entity import LaunchDescriptionEntity


class InvalidChoicesError(RuntimeError, ValueError):
    """Raised if an argument has an empty list of choices, or a default that is not one of them."""


@expose_action("arg")
class DeclareLaunchArgument(Action):
    """Declares an argument of a launch file, with a default, a description and choices.

    An argument without a default must be given on the command line or by the including file.

    >>> from launch import LaunchContext
    >>> from launch.substitutions import LaunchConfiguration
    >>> context = LaunchContext()
    >>> DeclareLaunchArgument("robot", default_value="burger", choices=["burger", "waffle"]).execute(context)
    >>> LaunchConfiguration("robot").perform(context)
    'burger'
    """

    def __init__(
        self,
        name: str,
        *,
        default_value: SomeSubstitutionsType | None = None,
        description: str | None = None,
        choices: Iterable[str] | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__name = name
        self.__choices = None if choices is None else list(choices)
        if self.__choices is not None and not self.__choices:
            raise InvalidChoicesError("Provided choices arg is empty. Use None to ignore the choice list.")
        if self.__choices and isinstance(default_value, str) and default_value not in self.__choices:
            raise InvalidChoicesError(
                f'Provided default_value "{default_value}" is not in provided choices "{self.__choices}".'
            )
        self.__logger_name = "launch.actions.declare_launch_argument"
        self.__default = None if default_value is None else normalize_to_list_of_substitutions(default_value)
        self.__description = description if description is not None else "no description given"
        if self.__choices and description is None:
            self.__description = f"One of: {self.__choices}"
        elif self.__choices:
            self.__description = f"{self.__description.removesuffix('.')}. Valid choices are: {self.__choices}"
        self._conditionally_included = False

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """Read `<arg name= default= description=><choice value=/></arg>`."""
        _, kwargs = super().parse(entity, parser)
        kwargs["name"] = parser.escape_characters(entity.get_attr("name"))
        default = entity.get_attr("default", optional=True)
        if default is not None:
            kwargs["default_value"] = parser.parse_substitution(default)
        description = entity.get_attr("description", optional=True)
        if description is not None:
            kwargs["description"] = parser.escape_characters(description)
        choices = entity.get_attr("choice", data_type=list[Entity], optional=True)
        if choices is not None:
            kwargs["choices"] = [parser.escape_characters(choice.get_attr("value")) for choice in choices]
        return cls, kwargs

    @property
    def name(self) -> str:
        """The argument's name."""
        return self.__name

    @property
    def default_value(self) -> list[Substitution] | None:
        """The default, as substitutions."""
        return self.__default

    @property
    def description(self) -> str:
        """The description, with the choices."""
        return self.__description

    @property
    def choices(self) -> list[str] | None:
        """The allowed values; None for any."""
        return self.__choices

    def describe(self) -> str:
        """Return the argument with its default."""
        default = " + ".join(sub.describe() for sub in self.__default or [])
        return f"DeclareLaunchArgument('{self.__name}'{', default=' + default if self.__default else ''})"

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Set the default if the argument was not given; check the choices.

        Raises:
            RuntimeError: if a required argument is missing, or if the value is not one of the choices.
        """
        if self.__name not in context.launch_configurations:
            if self.__default is None:
                raise RuntimeError(self.__missing())
            context.launch_configurations[self.__name] = perform_substitutions(context, self.__default)
        value = context.launch_configurations[self.__name]
        if self.__choices is not None and value not in self.__choices:
            text = (
                f'Argument "{self.__name}" provided value "{value}" is not valid. '
                f"Valid options are: {self.__choices}"
            )
            get_logger(self.__logger_name).error(text)
            raise RuntimeError(text)
        return None

    def __missing(self) -> str:
        get_logger(self.__logger_name).debug(f"launch argument '{self.__name}' has no value and no default")
        return (
            f"Required launch argument '{self.__name}' (description: '{self.__description}') was not "
            f"provided; give it as {self.__name}:=VALUE"
        )
