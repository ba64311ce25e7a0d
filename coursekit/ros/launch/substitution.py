"""The base class of all substitutions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .launch_context import LaunchContext


class Substitution:
    """A value that is known only when the launch file runs; `perform` returns its text."""

    @classmethod
    def parse(cls, data: Sequence[Any]) -> tuple[type[Substitution], dict[str, Any]]:
        """Return the class and the keyword arguments for `$(name ...)` in XML or YAML.

        Raises:
            RuntimeError: if arguments are given to a substitution that takes none.
        """
        if data:
            raise RuntimeError(f"{cls.__name__} takes no arguments, but {len(data)} were given")
        return cls, {}

    def describe(self) -> str:
        """Return a short description, as shown by `ros2 launch --print`."""
        return repr(self)

    def perform(self, context: LaunchContext) -> str:
        """Return the text of this substitution in `context`; subclasses override this."""
        return ""
