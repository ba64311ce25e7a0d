"""The output of a command."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from coursekit.processes import session
from coursekit.systems.command_lines import split_words
from coursekit.systems.layout import executable_name
from coursekit.wiring import command

from ..frontend.expose import expose_substitution
from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from ..utilities import normalize_to_list_of_substitutions, perform_substitutions
from .find_executable import which
from .substitution_failure import SubstitutionFailure

if TYPE_CHECKING:
    from ..launch_context import LaunchContext

_PLACE = re.compile("\ue000([0-9]+)\ue001")
"""A placeholder for a path while the command is split into words: a folder such as `José Luis` must stay one word."""
ON_STDERR = ("fail", "ignore", "warn", "capture")


@expose_substitution("command")
class Command(Substitution):
    """A command's standard output, for example xacro's robot description.

    `on_stderr` is the reaction to output on the command's standard error: 'fail', 'warn', 'ignore', or
    'capture' (the error output becomes part of the text).

    >>> from launch import LaunchContext
    >>> Command(["ros2", " ", "pkg", " ", "--help"]).describe()
    "Command('ros2' + ' ' + 'pkg' + ' ' + '--help')"
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
        """The reaction to error output, as substitutions."""
        return self.__on_stderr

    def describe(self) -> str:
        """Return a description of the command."""
        return f"Command({' + '.join(sub.describe() for sub in self.__command)})"

    def perform(self, context: LaunchContext) -> str:
        """Run the command and return its output.

        Raises:
            SubstitutionFailure: if it cannot be run, if it fails, or if it prints errors and `on_stderr` is 'fail'.
        """
        pieces = [perform_substitutions(context, [piece]) for piece in self.__command]
        text = "".join(pieces)
        on_stderr = perform_substitutions(context, self.__on_stderr)
        if on_stderr not in ON_STDERR:
            raise SubstitutionFailure(
                f"expected 'on_stderr' to be one of {list(ON_STDERR)}, got '{on_stderr}'"
            )
        try:
            done = _run(pieces, dict(context.environment), merge=on_stderr == "capture")
        except ValueError as error:
            raise SubstitutionFailure(
                f"the command cannot be divided into words: {error}. Command: {text}\n"
                "Give a path as an item of its own: Command(['xacro ', path])"
            ) from None
        if done.returncode != 0:
            raise SubstitutionFailure(
                f"executed command failed. Command: {text}\n"
                f"Captured stderr output: {done.stderr or done.stdout}"
            )
        if done.stderr:
            _complain(text, done.stderr, on_stderr, context)
        return done.stdout


def _run(pieces: Sequence[str], environment: dict[str, str], merge: bool) -> subprocess.CompletedProcess[str]:
    paths = [piece for piece in pieces if os.path.isabs(piece) and os.path.exists(piece)]
    text = "".join(f"\ue000{paths.index(piece)}\ue001" if piece in paths else piece for piece in pieces)

    words = split_words(text)
    if not words:
        raise SubstitutionFailure("command substitution got an empty command")
    words = [_PLACE.sub(lambda match: paths[int(match[1])], word) for word in words]
    inside = command(executable_name(Path(words[0])))
    if inside is not None:
        return _run_inside(inside, words, environment, merge)
    program = which(words[0], environment.get("PATH"))
    if program is None:
        raise SubstitutionFailure(
            f"file not found: [Errno 2] No such file or directory: {words[0]!r}; it is not on the PATH"
        )
    return subprocess.run(
        [*_started(program), *words[1:]],
        env=environment,
        encoding="utf-8",
        errors="replace",
        check=False,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT if merge else subprocess.PIPE,
    )


def _run_inside(
    run: Callable[..., int], words: Sequence[str], environment: dict[str, str], merge: bool
) -> subprocess.CompletedProcess[str]:
    """Run a program such as `ros2` in the session, whose nodes it asks: a child process would not see their graph."""
    texts: dict[str, list[str]] = {"stdout": [], "stderr": []}

    def keep(stream: str, text: str) -> None:
        texts["stdout" if merge else stream].append(text)

    name, argv = executable_name(Path(words[0])), list(words[1:])
    process = session.current().start(lambda: run(argv), name=name, argv=argv, env=environment, on_output=keep)
    process.close_stdin()
    code = process.wait()
    return subprocess.CompletedProcess(words, code or 0, "".join(texts["stdout"]), "".join(texts["stderr"]))


def _started(program: str) -> list[str]:
    """Return the command for a program; xacro's own script raises an AttributeError instead of naming a missing file."""
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
