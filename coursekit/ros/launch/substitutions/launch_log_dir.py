"""The folder of this launch's log files."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..frontend.expose import expose_substitution
from .path_join_substitution import Extensible
from .text_substitution import TextSubstitution

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


@expose_substitution("launch_log_dir")
@expose_substitution("log_dir")
class LaunchLogDir(Extensible, TextSubstitution):
    """The absolute folder of this launch's log files. As in Humble, `$(log_dir)` is plain text as soon as it is parsed."""

    def __init__(self) -> None:
        super().__init__(text="")

    @property
    def text(self) -> str:
        """The folder."""
        from ..logging import launch_config

        return str(launch_config.log_dir)

    def describe(self) -> str:
        """Return the substitution's name."""
        return "LaunchLogDir()"

    def perform(self, context: LaunchContext) -> str:
        """Return the folder."""
        return self.text
