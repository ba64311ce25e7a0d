"""`ros2 launch`: runs a launch file of a package, or one given by its path."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Iterable, Iterator
from typing import Any

from coursekit.suggestions import hint

LAUNCH_FILE_ENDINGS = (
    ".launch.py",
    ".launch.xml",
    ".launch.yaml",
    ".launch.yml",
    "_launch.py",
    "_launch.xml",
    "_launch.yaml",
    "_launch.yml",
)


class LaunchFileError(Exception):
    """Raised when no launch file, or more than one, matches the request."""


def register(subparsers: Any) -> None:
    """Add the `launch` command to the parser of `ros2`."""
    parser = subparsers.add_parser("launch", help="Run a launch file", description="Run a launch file")
    parser.add_argument(
        "-n",
        "--noninteractive",
        action="store_true",
        help="Run with no terminal of its own: Ctrl-C is not passed on by a terminal",
    )
    parser.add_argument(
        "-d", "--debug", action="store_true", help="Put the launch system in debug mode, which prints more"
    )
    only = parser.add_mutually_exclusive_group()
    only.add_argument(
        "-p",
        "--print",
        "--print-description",
        dest="print_description",
        action="store_true",
        help="Print the launch description without launching it",
    )
    only.add_argument(
        "-s",
        "--show-args",
        "--show-arguments",
        dest="show_args",
        action="store_true",
        help="Show the arguments that may be given to the launch file",
    )
    parser.add_argument(
        "-a",
        "--show-all-subprocesses-output",
        action="store_true",
        help="Show what all processes print, whatever their output setting is",
    )
    parser.add_argument(
        "--launch-prefix", default=None, help="Command that goes before every executable, for example gdb"
    )
    parser.add_argument(
        "--launch-prefix-filter",
        default=None,
        help="Regular expression of the executables that get the launch prefix",
    )
    package = parser.add_argument("package_name", help="Name of the package, or path of a launch file")
    package.completer = complete_package_or_file  # type: ignore[attr-defined]
    file = parser.add_argument("launch_file_name", nargs="?", help="Name of the launch file")
    file.completer = complete_file_name  # type: ignore[attr-defined]
    parser.add_argument(
        "launch_arguments",
        nargs="*",
        help="Arguments of the launch file, as '<name>:=<value>'; the last one of a name wins",
    )
    parser.set_defaults(main=main)


def main(args: argparse.Namespace) -> int:
    """Run the command; return its exit code."""
    try:
        path, arguments = find_launch_file(args.package_name, args.launch_file_name, args.launch_arguments)
        pairs = parse_launch_arguments(arguments)
    except LaunchFileError as error:
        print(error, file=sys.stderr)
        return 1
    if args.show_all_subprocesses_output:
        os.environ["OVERRIDE_LAUNCH_PROCESS_OUTPUT"] = "both"
    if args.print_description or args.show_args:
        return _show(path, arguments_only=args.show_args)
    return _launch(path, arguments, [*pairs, *_prefix_arguments(args)], args)


def find_launch_file(
    package_or_path: str, name: str | None, arguments: Iterable[str]
) -> tuple[str, list[str]]:
    """Return the launch file's path and the arguments for it.

    Raises:
        LaunchFileError: when there is no such package or file, or several of that name.
    """
    from ament_index_python.packages import PackageNotFoundError, get_package_share_directory

    if name is None or ":=" in name:
        first = [] if name is None else [name]
        return _existing(package_or_path), [*first, *arguments]
    try:
        share = get_package_share_directory(package_or_path)
    except (PackageNotFoundError, ValueError) as error:
        if os.path.isfile(package_or_path):
            return package_or_path, [name, *arguments]
        raise LaunchFileError(
            f"Package '{package_or_path}' not found: {error}{_near_package(package_or_path)}"
        ) from None
    return file_in_share(package_or_path, share, name), list(arguments)


def _existing(path: str) -> str:
    if os.path.isfile(path):
        return path
    from ament_index_python.packages import get_packages_with_prefixes

    if path in get_packages_with_prefixes():
        files = ", ".join(sorted(complete_file_name("", argparse.Namespace(package_name=path)))) or "none"
        raise LaunchFileError(f"No launch file supplied; package '{path}' has: {files}")
    raise LaunchFileError(
        f"No launch file supplied: there is no file '{path}'; type ros2 launch PACKAGE FILE"
    )


def _near_package(name: str) -> str:
    from ament_index_python.packages import get_packages_with_prefixes

    return hint(name, sorted(get_packages_with_prefixes()))


def file_in_share(package: str, share: str, name: str) -> str:
    """Return the only file of that name below a package's share folder.

    Raises:
        LaunchFileError: when there is none, or more than one.
    """
    files = [path for path in _files(share) if os.path.basename(path) == name]
    if not files:
        known = sorted(os.path.basename(path) for path in _files(share) if path.endswith(LAUNCH_FILE_ENDINGS))
        raise LaunchFileError(
            f"file '{name}' was not found in the share directory of package '{package}' which is at '{share}'"
            f"{'; its launch files: ' + ', '.join(known) if known else ''}"
        )
    if len(files) > 1:
        paths = ", ".join(f"'{path}'" for path in files)
        raise LaunchFileError(
            f"file '{name}' was found more than once in the share directory of package '{package}': [{paths}]"
        )
    return files[0]


def _files(folder: str) -> Iterator[str]:
    for root, folders, names in os.walk(folder):
        folders.sort()
        for name in sorted(names):
            yield os.path.join(root, name)


def parse_launch_arguments(arguments: Iterable[str]) -> list[tuple[str, str]]:
    """Return (name, value) of each `name:=value`; the last one of a name wins.

    >>> parse_launch_arguments(['a:=1', 'b:=2', 'a:=3'])
    [('a', '3'), ('b', '2')]

    Raises:
        LaunchFileError: when one has another form.
    """
    pairs: dict[str, str] = {}
    for argument in arguments:
        name, sign, value = argument.partition(":=")
        if not sign or not name or not value:
            raise LaunchFileError(
                f"malformed launch argument '{argument}', expected format '<name>:=<value>'"
            )
        pairs[name] = value
    return list(pairs.items())


def _prefix_arguments(args: argparse.Namespace) -> list[tuple[str, str]]:
    settings = {"launch-prefix": args.launch_prefix, "launch-prefix-filter": args.launch_prefix_filter}
    return [(name, value) for name, value in settings.items() if value is not None]


def _launch(path: str, arguments: list[str], pairs: list[tuple[str, str]], args: argparse.Namespace) -> int:
    from launch import LaunchDescription, LaunchService
    from launch.actions import IncludeLaunchDescription
    from launch.launch_description_sources import AnyLaunchDescriptionSource

    service = LaunchService(argv=arguments, noninteractive=args.noninteractive, debug=args.debug)
    service.include_launch_description(
        LaunchDescription(
            [IncludeLaunchDescription(AnyLaunchDescriptionSource(path), launch_arguments=pairs)]
        )
    )
    return service.run()


def _show(path: str, arguments_only: bool) -> int:
    from launch import InvalidLaunchFileError, LaunchIntrospector
    from launch.launch_description_sources import get_launch_description_from_any_launch_file
    from launch.utilities.arguments import arguments_text

    try:
        description = get_launch_description_from_any_launch_file(path)
    except InvalidLaunchFileError as error:
        print(error, file=sys.stderr)
        return 1
    print(
        arguments_text(description)
        if arguments_only
        else LaunchIntrospector().format_launch_description(description)
    )
    return 0


def complete_package_or_file(prefix: str, **_: Any) -> list[str]:
    """Return the packages, and the launch files and folders here, that begin with `prefix`."""
    from ament_index_python.packages import get_packages_with_prefixes

    folder = os.path.dirname(prefix)
    names = sorted(os.listdir(folder or ".")) if os.path.isdir(folder or ".") else []
    paths = [os.path.join(folder, name) for name in names]
    files = [path for path in paths if path.endswith(LAUNCH_FILE_ENDINGS)]
    folders = [path + os.sep for path in paths if os.path.isdir(path)]
    return [
        name for name in [*sorted(get_packages_with_prefixes()), *files, *folders] if name.startswith(prefix)
    ]


def complete_file_name(prefix: str, parsed_args: argparse.Namespace, **_: Any) -> list[str]:
    """Return the launch files of the package that begin with `prefix`."""
    from ament_index_python.packages import PackageNotFoundError, get_package_share_directory

    try:
        share = get_package_share_directory(parsed_args.package_name)
    except (PackageNotFoundError, ValueError):
        return []
    names = [os.path.basename(path) for path in _files(share) if path.endswith(LAUNCH_FILE_ENDINGS)]
    return [name for name in names if name.startswith(prefix)]
