"""The value of a launch configuration."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from ..frontend.expose import expose_substitution
from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from ..utilities import normalize_to_list_of_substitutions, perform_substitutions
from .substitution_failure import SubstitutionFailure

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


@expose_substitution("var")
class LaunchConfiguration(Substitution):
    """The value that a launch argument or SetLaunchConfiguration has set for a name.

    >>> from launch import LaunchContext
    >>> LaunchConfiguration('speed', default='1').perform(LaunchContext())
    '1'
    """

    def __init__(self, variable_name: SomeSubstitutionsType, *, default: Any = None) -> None:
        super().__init__()
        self.__variable_name = normalize_to_list_of_substitutions(variable_name)
        self.__default = None if default is None else normalize_to_list_of_substitutions(_as_texts(default))

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[Substitution], dict[str, Any]]:
        """Read `$(var name)` or `$(var name default)`."""
        if not 1 <= len(data) <= 2:
            raise TypeError(f"$(var ...) takes a name and perhaps a default, got {len(data)} arguments")
        kwargs: dict[str, Any] = {"variable_name": data[0]}
        if len(data) == 2:
            kwargs["default"] = data[1]
        return cls, kwargs

    @property
    def variable_name(self) -> list[Substitution]:
        """The name, as substitutions."""
        return self.__variable_name

    def describe(self) -> str:
        """Return a description of the configuration's name."""
        return f"LaunchConfig({' + '.join(sub.describe() for sub in self.__variable_name)})"

    def perform(self, context: LaunchContext) -> str:
        """Return the value, or the default.

        Raises:
            SubstitutionFailure: if there is neither.
        """
        name = perform_substitutions(context, self.__variable_name)
        if name in context.launch_configurations:
            return context.launch_configurations[name]
        if self.__default is None:
            raise SubstitutionFailure(f"launch configuration '{name}' does not exist")
        return perform_substitutions(context, self.__default)


def _as_texts(default: Any) -> Any:
    """Return the defaults with numbers and truth values converted to text."""
    if isinstance(default, (str, Substitution)):
        return default
    if isinstance(default, Iterable):
        return [item if isinstance(item, (str, Substitution)) else str(item) for item in default]
    return str(default)
