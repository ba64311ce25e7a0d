"""The folders of installed packages."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ament_index_python.packages import get_package_prefix, get_package_share_directory
from launch.frontend import expose_substitution
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions.path_join_substitution import Extensible
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions


class FindPackage(Extensible):
    """A folder of a package; a subclass determines which."""

    def __init__(self, package: SomeSubstitutionsType) -> None:
        super().__init__()
        self.__package = normalize_to_list_of_substitutions(package)

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[Substitution], dict[str, Any]]:
        """Read `$(find-pkg-share name)` and similar substitutions."""
        if len(data) != 1:
            raise AttributeError("find package substitutions expect 1 argument")
        return cls, {"package": data[0]}

    @property
    def package(self) -> list[Substitution]:
        """The package's name, as substitutions."""
        return self.__package

    def describe(self) -> str:
        """Return a description of the package's name."""
        return f"{type(self).__name__}(pkg={' + '.join(sub.describe() for sub in self.__package)})"

    def find(self, package_name: str) -> str:
        """Return the folder."""
        return get_package_prefix(package_name)

    def perform(self, context: LaunchContext) -> str:
        """Return the folder.

        Raises:
            PackageNotFoundError: if there is no such package.
        """
        return self.find(perform_substitutions(context, self.__package))


@expose_substitution("find-pkg-prefix")
class FindPackagePrefix(FindPackage):
    """The folder in which a package is installed."""


@expose_substitution("find-pkg-share")
class FindPackageShare(FindPackage):
    """The package's share folder, with launch files and configuration.

    >>> from launch import LaunchContext
    >>> from launch.substitutions import PathJoinSubstitution
    >>> urdf = PathJoinSubstitution([FindPackageShare("urdf_tutorial"), "urdf", "01-myfirst.urdf"])
    >>> urdf.perform(LaunchContext()).endswith("01-myfirst.urdf")
    True
    """

    def find(self, package_name: str) -> str:
        """Return the folder."""
        return get_package_share_directory(package_name)
