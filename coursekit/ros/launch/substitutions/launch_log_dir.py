"""Where this launch writes its log files."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..frontend.expose import expose_substitution
from ..substitution import Substitution

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


@expose_substitution("launch_log_dir")
@expose_substitution("log_dir")
class LaunchLogDir(Substitution):
    """The absolute folder of this launch's log files."""

    def describe(self) -> str:
        """Return the substitution's name."""
        return "LaunchLogDir()"

    def perform(self, context: LaunchContext) -> str:
        """Return the folder."""
        from ..logging import launch_config

        return str(launch_config.log_dir)
