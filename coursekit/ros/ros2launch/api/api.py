"""The functions of ros2launch.api."""

from __future__ import annotations

import os
from argparse import Namespace
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from ament_index_python.packages import PackageNotFoundError, get_package_share_directory
from launch import LaunchDescription, LaunchIntrospector, LaunchService
from launch.actions import IncludeLaunchDescription
from launch.frontend import Parser
from launch.launch_description_sources import (
    AnyLaunchDescriptionSource,
    get_launch_description_from_any_launch_file,
)
from launch.utilities.arguments import arguments_text

from coursekit.cli.verbs import launch as verb


class MultipleLaunchFilesError(Exception):
    """Raised when a package has several files of a name; `paths` has them."""

    def __init__(self, msg: str, paths: list[str]) -> None:
        super().__init__(msg)
        self.paths = paths


def get_share_file_path_from_package(*, package_name: str, file_name: str) -> str:
    """Return the only file of that name below a package's share folder.

    Raises:
        PackageNotFoundError: when there is no such package.
        FileNotFoundError: when it has no such file.
        MultipleLaunchFilesError: when it has several.
    """
    share = get_package_share_directory(package_name)
    try:
        return verb.file_in_share(package_name, share, file_name)
    except verb.LaunchFileError as error:
        paths = [str(path) for path in sorted(Path(share).rglob(file_name))]
        if paths:
            raise MultipleLaunchFilesError(str(error), paths) from None
        raise FileNotFoundError(str(error)) from None


def is_launch_file(path: str) -> bool:
    """Return whether a file's name ends as a launch file's."""
    endings = ("launch.py", *(f"launch.{ending}" for ending in Parser.get_available_extensions()))
    return path.endswith(endings) and os.path.isfile(path)


def get_launch_file_paths(*, path: str) -> list[str]:
    """Return the launch files in a folder and below."""
    paths = (os.path.join(root, name) for root, _, names in os.walk(path) for name in sorted(names))
    return [path for path in paths if is_launch_file(path)]


def print_a_launch_file(*, launch_file_path: str) -> None:
    """Print what a launch file describes."""
    description = get_launch_description_from_any_launch_file(launch_file_path)
    print(LaunchIntrospector().format_launch_description(description))


def print_arguments_of_launch_description(*, launch_description: LaunchDescription) -> None:
    """Print the arguments of a launch description."""
    print(arguments_text(launch_description))


def print_arguments_of_launch_file(*, launch_file_path: str) -> None:
    """Print the arguments of a launch file."""
    description = get_launch_description_from_any_launch_file(launch_file_path)
    print_arguments_of_launch_description(launch_description=description)


def parse_launch_arguments(launch_arguments: Iterable[str]) -> list[tuple[str, str]]:
    """Return (name, value) of each `name:=value`; RuntimeError when one has another form."""
    try:
        return verb.parse_launch_arguments(launch_arguments)
    except verb.LaunchFileError as error:
        raise RuntimeError(str(error)) from None


def launch_a_launch_file(
    *,
    launch_file_path: str,
    launch_file_arguments: list[str],
    noninteractive: bool = False,
    args: Namespace | None = None,
    option_extensions: Any = None,
    debug: bool = False,
) -> int:
    """Run a launch file with arguments such as `name:=value`; return its exit code."""
    service = LaunchService(argv=launch_file_arguments, noninteractive=noninteractive, debug=debug)
    pairs = parse_launch_arguments(launch_file_arguments)
    included = IncludeLaunchDescription(AnyLaunchDescriptionSource(launch_file_path), launch_arguments=pairs)
    service.include_launch_description(LaunchDescription([included]))
    return service.run()


class LaunchFileNameCompleter:
    """Offers the names of a package's launch files; the package stands in the argument `package_name_key`."""

    def __init__(self, *, package_name_key: str | None = None) -> None:
        self.package_name_key = package_name_key or "package_name"

    def __call__(self, prefix: str, parsed_args: Namespace, **kwargs: Any) -> list[str]:
        """Return the names; none for a package that is not there."""
        try:
            share = get_package_share_directory(getattr(parsed_args, self.package_name_key))
        except PackageNotFoundError:
            return []
        return [os.path.basename(path) for path in get_launch_file_paths(path=share)]
