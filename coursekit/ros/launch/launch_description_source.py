"""The base class of sources of launch descriptions, usually files."""

from __future__ import annotations

from typing import TYPE_CHECKING

from coursekit.files import installed

from .some_substitutions_type import SomeSubstitutionsType
from .substitution import Substitution
from .utilities import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from .launch_context import LaunchContext
    from .launch_description import LaunchDescription


class LaunchDescriptionSource:
    """A launch description that is created on demand, by default from the file at `location`."""

    def __init__(
        self,
        launch_description: LaunchDescription | None = None,
        location: SomeSubstitutionsType = "<string>",
        method: str = "unspecified mechanism from a script",
    ) -> None:
        self.__launch_description = launch_description
        self.__location = normalize_to_list_of_substitutions(location)
        self.__expanded_location: str | None = None
        self.__method = method

    def try_get_launch_description_without_context(self) -> LaunchDescription | None:
        """Return the description if it is available before launching, else None."""
        if self.__launch_description is not None:
            return self.__launch_description
        from .launch_context import LaunchContext

        try:
            return self._get_launch_description(installed(perform_substitutions(LaunchContext(), self.__location)))
        except Exception:
            return None

    def get_launch_description(self, context: LaunchContext) -> LaunchDescription:
        """Return the description; the location's substitutions are performed in `context`."""
        if self.__expanded_location is None:
            self.__expanded_location = installed(perform_substitutions(context, self.__location))
        if self.__launch_description is None:
            self.__launch_description = self._get_launch_description(self.__expanded_location)
        return self.__launch_description

    def _get_launch_description(self, location: str) -> LaunchDescription:
        """Return the description of a location; subclasses override this."""
        raise RuntimeError(f"{type(self).__name__} cannot load {location}: use a source for files")

    @property
    def location(self) -> str:
        """The location: the path, or its substitutions until it is known."""
        if self.__expanded_location is None:
            return " + ".join(str(sub) for sub in self.__location)
        return self.__expanded_location

    def describe_location(self) -> str:
        """Return the path, or a description of its substitutions until it is known."""
        if self.__expanded_location is None:
            return " + ".join(sub.describe() for sub in self.__location)
        return self.__expanded_location

    @property
    def location_substitutions(self) -> list[Substitution]:
        """The location, as substitutions."""
        return self.__location

    @property
    def method(self) -> str:
        """A description of how the launch description is created."""
        return self.__method
