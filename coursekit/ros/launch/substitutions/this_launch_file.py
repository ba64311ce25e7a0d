"""The path and folder of the current launch file."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..frontend.expose import expose_substitution
from ..substitution import Substitution
from .path_join_substitution import Extensible
from .substitution_failure import SubstitutionFailure

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


@expose_substitution("filename")
class ThisLaunchFile(Substitution):
    """The absolute path of this launch file."""

    def describe(self) -> str:
        """Return the substitution's name."""
        return "ThisLaunchFile()"

    def perform(self, context: LaunchContext) -> str:
        """Return the path.

        Raises:
            SubstitutionFailure: outside of a launch file.
        """
        path = context.get_locals_as_dict().get("current_launch_file_path")
        if path is None:
            raise SubstitutionFailure("ThisLaunchFile used outside of a launch file (in a script)")
        return str(path)


@expose_substitution("dirname")
class ThisLaunchFileDir(Extensible):
    """The absolute folder of this launch file."""

    def describe(self) -> str:
        """Return the substitution's name."""
        return "ThisLaunchFileDir()"

    def perform(self, context: LaunchContext) -> str:
        """Return the folder.

        Raises:
            SubstitutionFailure: outside of a launch file.
        """
        folder = context.get_locals_as_dict().get("current_launch_file_directory")
        if folder is None:
            raise SubstitutionFailure("ThisLaunchFileDir used outside of a launch file (in a script)")
        return str(folder)
