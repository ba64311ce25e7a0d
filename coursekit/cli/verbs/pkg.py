"""`ros2 pkg`: create, list, prefix, executables, xml."""

from __future__ import annotations

import argparse
from typing import Any

from coursekit.packages import listing
from coursekit.packages.create import add_create_arguments, create


def register(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the command `pkg` with its verbs; each sets `main`, a function of the parsed arguments."""
    parser = subparsers.add_parser("pkg", help="Various package related sub-commands")
    verbs = parser.add_subparsers(
        title="Commands", metavar="Call `ros2 pkg <command> -h` for more detailed usage."
    )
    verbs.required = True
    _create(verbs)
    _list(verbs)
    _prefix(verbs)
    _executables(verbs)
    _xml(verbs)


def _create(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    parser = verbs.add_parser("create", help="Create a new ROS 2 package")
    add_create_arguments(parser)
    parser.set_defaults(main=create)


def _list(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    verbs.add_parser("list", help="Output a list of available packages").set_defaults(
        main=listing.list_packages
    )


def _prefix(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    parser = verbs.add_parser("prefix", help="Output the prefix path of a package")
    _package_argument(parser)
    parser.add_argument("--share", action="store_true", help="Show share directory for the package")
    parser.set_defaults(main=listing.print_prefix)


def _executables(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    parser = verbs.add_parser("executables", help="Output a list of package specific executables")
    _package_argument(parser, nargs="?")
    parser.add_argument("--full-path", action="store_true", help="Show full path of each executable")
    parser.set_defaults(main=listing.print_executables)


def _xml(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    parser = verbs.add_parser("xml", help="Output the package xml manifest or a specific tag")
    _package_argument(parser)
    parser.add_argument("-t", "--tag", help="The package's xml's tag to print")
    parser.set_defaults(main=listing.print_xml)


def _package_argument(parser: argparse.ArgumentParser, **options: Any) -> None:
    argument = parser.add_argument("package_name", help="The package name", **options)
    argument.completer = _package_names  # type: ignore[attr-defined]


def _package_names(**_: Any) -> list[str]:
    from ament_index_python import get_packages_with_prefixes

    return sorted(get_packages_with_prefixes())
