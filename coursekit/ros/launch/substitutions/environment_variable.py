"""The value of an environment variable."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ..frontend.expose import expose_substitution
from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from ..utilities import normalize_to_list_of_substitutions, perform_substitutions
from .substitution_failure import SubstitutionFailure

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


@expose_substitution("env")
class EnvironmentVariable(Substitution):
    """The value of an environment variable when the launch file runs.

    >>> from launch import LaunchContext
    >>> EnvironmentVariable("TURTLEBOT3_MODEL_OF_NOBODY", default_value="burger").perform(LaunchContext())
    'burger'
    """

    def __init__(
        self, name: SomeSubstitutionsType, *, default_value: SomeSubstitutionsType | None = None
    ) -> None:
        super().__init__()
        self.__name = normalize_to_list_of_substitutions(name)
        self.__default = None if default_value is None else normalize_to_list_of_substitutions(default_value)

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[Substitution], dict[str, Any]]:
        """Read `$(env NAME)` or `$(env NAME default)`."""
        if not 1 <= len(data) <= 2:
            raise TypeError(f"$(env ...) takes a name and perhaps a default, got {len(data)} arguments")
        kwargs: dict[str, Any] = {"name": data[0]}
        if len(data) == 2:
            kwargs["default_value"] = data[1]
        return cls, kwargs

    @property
    def name(self) -> list[Substitution]:
        """The name, as substitutions."""
        return self.__name

    @property
    def default_value(self) -> list[Substitution] | None:
        """The value if the variable is not set."""
        return self.__default

    def describe(self) -> str:
        """Return a description of the variable's name."""
        return f"EnvVar({' + '.join(sub.describe() for sub in self.__name)})"

    def perform(self, context: LaunchContext) -> str:
        """Return the variable's value, or the default.

        Raises:
            SubstitutionFailure: if there is neither.
        """
        name = perform_substitutions(context, self.__name)
        if name in context.environment:
            return context.environment[name]
        if self.__default is None:
            raise SubstitutionFailure(f"environment variable '{name}' does not exist")
        return perform_substitutions(context, self.__default)
