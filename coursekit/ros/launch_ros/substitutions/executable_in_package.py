"""The path of a package's executable."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from launch.frontend import expose_substitution
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions

from coursekit.processes.executables import why_missing, why_skipped
from coursekit.systems.layout import executable_files, is_executables_part

from .find_package import FindPackagePrefix


class NotCompiled(SubstitutionFailure):
    """The executable is a C++ program that `colcon build` skipped; `why` is the explanation."""

    def __init__(self, text: str, why: str) -> None:
        super().__init__(text)
        self.why = why


@expose_substitution("exec-in-pkg")
class ExecutableInPackage(FindPackagePrefix):
    """The path of an executable in a package's `lib/<package>` folder."""

    def __init__(self, executable: SomeSubstitutionsType, package: SomeSubstitutionsType) -> None:
        super().__init__(package)
        self.__executable = normalize_to_list_of_substitutions(executable)

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[Substitution], dict[str, Any]]:
        """Read `$(exec-in-pkg executable package)`."""
        if len(data) != 2:
            raise AttributeError("exec-in-pkg substitution expects 2 arguments")
        return cls, {"executable": data[0], "package": data[1]}

    @property
    def executable(self) -> list[Substitution]:
        """The executable's name, as substitutions."""
        return self.__executable

    def describe(self) -> str:
        """Return a description of package and executable."""
        package = " + ".join(sub.describe() for sub in self.package)
        executable = " + ".join(sub.describe() for sub in self.__executable)
        return f"ExecInPkg(pkg={package}, exec={executable})"

    def perform(self, context: LaunchContext) -> str:
        """Return the path.

        Raises:
            PackageNotFoundError: if there is no such package.
            SubstitutionFailure: if the package has no such executable; the message lists its executables.
            NotCompiled: if the package would have it, were it compiled.
        """
        executable = perform_substitutions(context, self.__executable)
        package = perform_substitutions(context, self.package)
        folder = os.path.join(super().perform(context), "lib", package)
        for path in executable_files(Path(folder), executable):
            if path.is_file():
                return str(path)
        known = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
        known = [name for name in known if _is_program(Path(folder, name))]
        text = (
            f"executable '{executable}' not found on the libexec directory '{folder}'"
            f"{'; the package has: ' + ', '.join(known) if known else '; the package has no executables'}"
        )
        if why := why_skipped(package, executable):
            raise NotCompiled(f"{text}; {why}", why)
        why = why_missing(package, executable)
        raise SubstitutionFailure(f"{text}{why and '; ' + why}")


def _is_program(path: Path) -> bool:
    return path.is_file() and not is_executables_part(path)
