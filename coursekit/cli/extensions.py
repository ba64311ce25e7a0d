"""Commands and verbs added to `ros2` by workspace packages, through entry points."""

from __future__ import annotations

import argparse
from typing import Any

from ros2cli.command import add_extension, get_command_extensions
from ros2cli.entry_points import get_entry_points
from ros2cli.verb import get_verb_extensions

from .api import Unhappy

COMMANDS = "ros2cli.command"
_GROUPS = {
    "control": "ros2controlcli.verb",
    "daemon": "ros2cli.daemon.verb",
    "security": "sros2.verb",
    "wtf": "ros2doctor.verb",
}
"""The groups of commands whose packages are not named `ros2COMMAND`."""


def group_of(command: str) -> str:
    """Return the entry point group of a command's verbs.

    >>> group_of("topic")
    'ros2topic.verb'
    """
    return _GROUPS.get(command, f"ros2{command}.verb")


def add_commands(subparsers: Any, known: list[str], wanted: str | None) -> None:
    """Add the packages' commands; only the wanted one if a package has it, to hide errors of the others."""
    names = get_entry_points(COMMANDS)
    left_out = [name for name in names if name != wanted] if wanted in names else known
    for name, extension in get_command_extensions(COMMANDS, exclude_names=left_out).items():
        parser = add_extension(subparsers, f"ros2 {name}", extension)
        parser.set_defaults(main=_carried_out(extension, parser))


def _carried_out(extension: Any, parser: argparse.ArgumentParser) -> Any:
    return lambda args: _code(extension.main, parser=parser, args=args)


def add_verbs(command: str, verbs: Any) -> None:
    """Add the packages' verbs to one of coursekit's commands."""
    for name, extension in get_verb_extensions(group_of(command)).items():
        if name not in verbs.choices:
            add_extension(verbs, f"ros2 {command}", extension).set_defaults(main=_verb(extension))


def _verb(extension: Any) -> Any:
    return lambda args: _code(extension.main, args=args)


def _code(main: Any, **words: Any) -> int:
    """Return the exit code of an extension; a returned text or a RuntimeError is its error message."""
    try:
        result = main(**words)
    except RuntimeError as error:
        result = str(error)
    if isinstance(result, str):
        raise Unhappy(result)
    return int(result or 0)
