"""`ros2 extension_points` and `ros2 extensions`: the extension points of `ros2`, and the installed extensions."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from ros2cli.entry_points import EXTENSION_POINT_GROUP_NAME, get_entry_points

from . import extensions

if TYPE_CHECKING:
    from argparse import ArgumentParser, Namespace


def register(subparsers: Any) -> None:
    """Add both commands."""
    for name, text, main in (
        ("extension_points", "List extension points", list_points),
        ("extensions", "List extensions", list_extensions),
    ):
        parser = subparsers.add_parser(name, help=text)
        parser.add_argument("-a", "--all", action="store_true", help="Also show those that cannot be loaded")
        parser.add_argument("-v", "--verbose", action="store_true", help="Show more information")
        parser.set_defaults(main=main)


def _groups() -> dict[str, list[str]]:
    """Return the names that `ros2` itself has for each extension point, including the points defined by packages."""
    from .parser import available, make_parser

    commands = available()
    groups = {extensions.COMMANDS: commands}
    subparsers = _choices(make_parser())
    for name in commands:
        verbs = _choices(subparsers[name])
        if verbs:
            groups[extensions.group_of(name)] = list(verbs)
    for name in get_entry_points(EXTENSION_POINT_GROUP_NAME):
        groups.setdefault(name, [])
    return groups


def _choices(parser: ArgumentParser) -> dict[str, Any]:
    actions = [action for action in parser._actions if isinstance(action, argparse._SubParsersAction)]
    return dict(actions[0].choices) if actions else {}


def list_points(args: Namespace) -> None:
    """Print the extension points."""
    added = get_entry_points(EXTENSION_POINT_GROUP_NAME)
    for group in sorted(_groups()):
        print(group)
        if args.verbose and group in added:
            print(f"  {added[group].value}")


def list_extensions(args: Namespace) -> None:
    """Print the extensions of each point."""
    for group, names in sorted(_groups().items()):
        added = get_entry_points(group)
        print(group)
        for name in sorted({*names, *added}):
            print(f"  {name}")
            if args.verbose and name in added:
                print(f"    {added[name].value}")
