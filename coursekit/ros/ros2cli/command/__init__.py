"""The base class of commands that packages add, and the search for a command's verbs."""

from __future__ import annotations

import argparse
import inspect
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ros2cli.plugin_system import PLUGIN_SYSTEM_VERSION, get_first_line_doc, instantiate_extensions, satisfies_version

if TYPE_CHECKING:
    from argparse import ArgumentParser, Namespace


class CommandExtension:
    """One command: `add_arguments(parser, cli_name)`, then `main(parser=..., args=...)`, whose return is the exit code."""

    NAME: str | None = None
    EXTENSION_POINT_VERSION = "0.1"

    def __init__(self) -> None:
        satisfies_version(PLUGIN_SYSTEM_VERSION, "^0.1")

    def add_arguments(self, parser: ArgumentParser, cli_name: str, *, argv: Any = None) -> None:
        """Add the command's arguments."""

    def main(self, *, parser: ArgumentParser, args: Namespace) -> Any:
        """Run the command."""
        raise NotImplementedError()


def get_command_extensions(group_name: str, *, exclude_names: Sequence[str] | None = None) -> dict[str, Any]:
    """The commands that packages add, by name."""
    return named(instantiate_extensions(group_name, exclude_names=exclude_names))


def named(extensions: dict[str, Any]) -> dict[str, Any]:
    """Extensions with their names set, in alphabetical order."""
    for name, extension in extensions.items():
        extension.NAME = name
    return dict(sorted(extensions.items()))


def add_subparsers_on_demand(
    parser: ArgumentParser,
    cli_name: str,
    dest: str,
    group_name: str,
    hide_extensions: Sequence[str] | None = None,
    required: bool = True,
    argv: Any = None,
) -> Any:
    """Add the verbs of a group to a command; `args.DEST` is then the verb on the command line."""
    title = f"Call `{cli_name} <command> -h` for more detailed usage."
    subparsers = parser.add_subparsers(title="Commands", metavar=title, required=required)
    subparsers.dest = " " + dest.lstrip("_")  # not `dest`, which is for the extension itself
    for name, extension in named(instantiate_extensions(group_name)).items():
        add_extension(subparsers, f"{cli_name} {name}", extension, name in (hide_extensions or ()), argv)
        subparsers.choices[name].set_defaults(**{dest: extension})
    return subparsers


def add_extension(subparsers: Any, cli_name: str, extension: Any, hidden: bool = False, argv: Any = None) -> Any:
    """Add the parser of one extension."""
    about = {} if hidden else {"help": get_first_line_doc(extension)}
    described = inspect.cleandoc(extension.__doc__ or "")
    added = subparsers.add_parser(
        extension.NAME, description=described, formatter_class=argparse.RawDescriptionHelpFormatter, **about
    )
    takes_words = "argv" in inspect.signature(extension.add_arguments).parameters
    extension.add_arguments(added, cli_name, **({"argv": argv} if takes_words else {}))
    return added
