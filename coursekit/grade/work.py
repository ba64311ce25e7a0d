"""What a judge sees of a student's work: variables of the notebook, files of the workspace, trials of the programs."""

from __future__ import annotations

import os
import shlex
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, TypeVar

from .trial import Plan, Seen, TrialFailed, try_out
from .verdict import Wrong

T = TypeVar("T")


class Work:
    """A student's work for one exercise."""

    def __init__(self, variables: Mapping[str, Any], workspace: Path) -> None:
        self.variables = variables
        self.workspace = workspace
        self.variants: Mapping[str, Any] = {}
        """What this student's copy asks for where it differs from the course's notebook."""

    def variant(self, name: str, usual: T) -> T:
        """A value that the exercise asks this student for; the `usual` one where there are no variants.

        >>> Work({}, Path()).variant("boxes", 10)
        10
        """
        found: Any = self.variants.get(name, usual)
        if type(found) is int and isinstance(usual, float):
            found = float(found)  # JSON of a browser knows no 3.0
        return found if type(found) is type(usual) else usual

    def value(self, name: str, kind: type[T]) -> T:
        """A variable of the notebook, of exactly that type."""
        if name not in self.variables:
            raise Wrong(f"a variable named `{name}`", "there is none", "Was the cell above run, and is the name right?")
        found = self.variables[name]
        if type(found) is not kind:
            raise Wrong(f"`{name}` as a {kind.__name__}", f"a {type(found).__name__}: {found!r:.80}")
        return found

    def function(self, name: str) -> Any:
        """A function of the notebook."""
        found = self.variables.get(name)
        if not callable(found):
            raise Wrong(f"a function named `{name}`", f"{found!r:.80}", "Was the cell above run?")
        return found

    def file(self, path: str) -> Path:
        """A file of the workspace that must exist."""
        found = self.workspace / path
        if not found.is_file():
            raise Wrong(f"the file {path} in {self.workspace.name}/", "it is not there", _near(found))
        return found

    def text(self, path: str) -> str:
        """The text of a file of the workspace."""
        return self.file(path).read_text(encoding="utf-8", errors="replace")

    def built(self, package: str) -> Path:
        """The install folder of a package of the workspace that must have been built."""
        prefix = self.workspace / "install" / package
        if not prefix.is_dir():
            prefix = self.workspace / "install"
        if not (prefix / "share" / "ament_index" / "resource_index" / "packages" / package).exists():
            raise Wrong(
                f"the package {package}, built", "it is not in install/", f"Run: %colcon build --packages-select {package}"
            )
        return prefix

    def environment(self) -> dict[str, str]:
        """The environment after sourcing the workspace."""
        from coursekit.packages.overlay import overlay_environment

        install = self.workspace / "install"
        env = dict(os.environ)
        return overlay_environment(install, env) if install.is_dir() else env

    def try_out(
        self, *commands: str, seconds: float = 3.0, later: Sequence[tuple[float, str]] = (), **plan: Any
    ) -> Seen:
        """Run `ros2` command lines (without that word) alone on the virtual clock; see `Plan` for the rest."""
        run, asked = [_words(one) for one in commands], [(when, _words(one)) for when, one in later]
        planned = Plan(run=run, seconds=seconds, later=asked, **plan)
        try:
            return try_out(planned, self.environment(), str(self.workspace))
        except TrialFailed as failure:
            raise Wrong("programs that run", str(failure)) from None


def _words(command: str) -> list[str]:
    try:
        return shlex.split(command)
    except ValueError:
        raise Wrong("a command line whose quotes come in pairs", command[:120]) from None


def _near(path: Path) -> str:
    folder = path.parent
    if not folder.is_dir():
        return f"The folder {folder.name}/ does not exist either."
    return f"{folder.name}/ has: {', '.join(sorted(one.name for one in folder.iterdir())[:8]) or 'nothing'}"
