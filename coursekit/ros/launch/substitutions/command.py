"""The output of a command."""

from __future__ import annotations

import os
import shlex
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..frontend.expose import expose_substitution
from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from ..utilities import normalize_to_list_of_substitutions, perform_substitutions
from .find_executable import which
from .substitution_failure import SubstitutionFailure

if TYPE_CHECKING:
    from ..launch_context import LaunchContext

ON_STDERR = ("fail", "ignore", "warn", "capture")


@expose_substitution("command")
class Command(Substitution):
    """What a command prints to its standard output, for example xacro's robot description.

    `on_stderr` says what to do when the command also prints to its standard error: 'fail', 'warn',
    'ignore', or 'capture' (then the error output is part of the text).
    """

    def __init__(self, command: SomeSubstitutionsType, *, on_stderr: SomeSubstitutionsType = "fail") -> None:
        super().__init__()
        self.__command = normalize_to_list_of_substitutions(command)
        self.__on_stderr = normalize_to_list_of_substitutions(on_stderr)

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[Substitution], dict[str, Any]]:
        """Read `$(command 'text')` or `$(command 'text' on_stderr)`."""
        if not 1 <= len(data) <= 2:
            raise ValueError("command substitution expects 1 or 2 arguments")
        kwargs: dict[str, Any] = {"command": data[0]}
        if len(data) == 2:
            kwargs["on_stderr"] = data[1]
        return cls, kwargs

    @property
    def command(self) -> list[Substitution]:
        """The command line, as substitutions."""
        return self.__command

    @property
    def on_stderr(self) -> list[Substitution]:
        """What to do about error output, as substitutions."""
        return self.__on_stderr

    def describe(self) -> str:
        """Return the command in words."""
        return f"Command({' + '.join(sub.describe() for sub in self.__command)})"

    def perform(self, context: LaunchContext) -> str:
        """Run the command and return its output.

        Raises:
            SubstitutionFailure: when it cannot be run, fails, or prints errors and that is to fail.
        """
        text = perform_substitutions(context, self.__command)
        on_stderr = perform_substitutions(context, self.__on_stderr)
        if on_stderr not in ON_STDERR:
            raise SubstitutionFailure(
                f"expected 'on_stderr' to be one of {list(ON_STDERR)}, got '{on_stderr}'"
            )
        done = _run(text, dict(context.environment), merge=on_stderr == "capture")
        if done.returncode != 0:
            raise SubstitutionFailure(
                f"executed command failed. Command: {text}\n"
                f"Captured stderr output: {done.stderr or done.stdout}"
            )
        if done.stderr:
            _complain(text, done.stderr, on_stderr, context)
        return done.stdout


def _run(text: str, environment: dict[str, str], merge: bool) -> subprocess.CompletedProcess[str]:
    words = shlex.split(text, posix=os.name != "nt")
    if not words:
        raise SubstitutionFailure("command substitution got an empty command")
    program = which(words[0], environment.get("PATH"))
    if program is None:
        raise SubstitutionFailure(
            f"file not found: [Errno 2] No such file or directory: {words[0]!r}; it is not on the PATH"
        )
    return subprocess.run(
        [*_started(program), *words[1:]],
        env=environment,
        text=True,
        check=False,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT if merge else subprocess.PIPE,
    )


def _started(program: str) -> list[str]:
    """How to start a program: xacro's own script ends in an AttributeError where it should name the missing file."""
    beside = Path(sys.executable).parent
    if Path(program).parent == beside and Path(program).stem == "xacro":
        return [sys.executable, "-c", "import sys, xml.parsers.expat, xacro; sys.exit(xacro.main())"]
    return [program]


def _complain(text: str, stderr: str, on_stderr: str, context: LaunchContext) -> None:
    message = f"executed command showed stderr output. Command: {text}\nCaptured stderr output:\n{stderr}"
    if on_stderr == "fail":
        raise SubstitutionFailure(message)
    if on_stderr == "warn":
        from ..logging import get_logger

        get_logger("launch").warning(message)
