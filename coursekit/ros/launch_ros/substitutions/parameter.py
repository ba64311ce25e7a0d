"""The value of a parameter that the launch file has set for all nodes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from launch.frontend import expose_substitution
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions


@expose_substitution("param")
class Parameter(Substitution):
    """The value that SetParameter has set for a name, as text."""

    def __init__(self, name: SomeSubstitutionsType, *, default: Any = None) -> None:
        super().__init__()
        self.__name = normalize_to_list_of_substitutions(name)
        self.__default = (
            None
            if default is None
            else normalize_to_list_of_substitutions(
                default if isinstance(default, (str, Substitution, list, tuple)) else str(default)
            )
        )

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[Substitution], dict[str, Any]]:
        """Read `$(param name)` or `$(param name default)`."""
        if not 1 <= len(data) <= 2:
            raise TypeError("param substitution expects 1 or 2 arguments")
        return cls, dict(zip(("name", "default"), data, strict=False))

    @property
    def name(self) -> list[Substitution]:
        """The name, as substitutions."""
        return self.__name

    @property
    def default(self) -> list[Substitution] | None:
        """The value if the parameter is not set."""
        return self.__default

    def describe(self) -> str:
        """Return a description of the name."""
        return f"Parameter({' + '.join(sub.describe() for sub in self.__name)})"

    def perform(self, context: LaunchContext) -> str:
        """Return the last value that was set, or the default.

        Raises:
            SubstitutionFailure: if there is neither.
        """
        name = perform_substitutions(context, self.__name)
        settings: Any = context.launch_configurations.get("global_params", [])
        for setting in reversed(settings):
            if isinstance(setting, tuple) and setting[0] == name:
                return str(setting[1])
        if self.__default is not None:
            return perform_substitutions(context, self.__default)
        raise SubstitutionFailure(f"parameter '{name}' not found; set it with SetParameter before")
