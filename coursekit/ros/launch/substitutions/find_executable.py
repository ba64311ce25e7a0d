"""The path of a program on the PATH."""

from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ..frontend.expose import expose_substitution
from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from ..utilities import normalize_to_list_of_substitutions, perform_substitutions
from .substitution_failure import SubstitutionFailure

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


def which(name: str, path: str | None) -> str | None:
    """Return the program's path, searched on `path` and in the folder of the running Python."""
    beside = os.path.dirname(sys.executable)
    return shutil.which(name, path=path) or shutil.which(name, path=beside)


@expose_substitution("find-exec")
class FindExecutable(Substitution):
    """The full path of a program."""

    def __init__(self, *, name: SomeSubstitutionsType) -> None:
        super().__init__()
        self.__name = normalize_to_list_of_substitutions(name)

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[Substitution], dict[str, Any]]:
        """Read `$(find-exec name)`."""
        if len(data) != 1:
            raise AttributeError("find-exec substitution expects 1 argument")
        return cls, {"name": data[0]}

    @property
    def name(self) -> list[Substitution]:
        """The program's name, as substitutions."""
        return self.__name

    def describe(self) -> str:
        """Return a description of the program's name."""
        return f"FindExec({' + '.join(sub.describe() for sub in self.__name)})"

    def perform(self, context: LaunchContext) -> str:
        """Return the path.

        Raises:
            SubstitutionFailure: if there is no such program.
        """
        name = perform_substitutions(context, self.__name)
        path = which(name, context.environment.get("PATH"))
        if path is None:
            raise SubstitutionFailure(f"executable '{name}' not found on the PATH")
        return path
