"""The executables of a package by name, as launch files use them."""

from __future__ import annotations

import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ros2pkg.api import PackageNotFound, get_executable_paths

from coursekit.processes.prefixed import prefixed
from coursekit.systems.layout import executable_name as executable_name_of
from coursekit.systems.signal_names import described

if TYPE_CHECKING:
    from argparse import Namespace

__all__ = ["ExecutableNameCompleter", "MultipleExecutables", "PackageNotFound", "get_executable_path", "run_executable"]

ROS2RUN_MSG_PREFIX = "[ros2run]:"


class MultipleExecutables(Exception):
    """More than one executable has the name; `paths` are their files."""

    def __init__(self, paths: list[str]) -> None:
        super().__init__(paths)
        self.paths = paths


def get_executable_path(*, package_name: str, executable_name: str) -> str | None:
    """The file of an executable; None if the package has none of that name. Raises PackageNotFound.

    >>> Path(get_executable_path(package_name="demo_nodes_py", executable_name="talker")).parts[-2:]
    ('demo_nodes_py', 'talker')
    """
    executables = map(Path, get_executable_paths(package_name=package_name))
    paths = [str(path) for path in executables if executable_name in (path.name, executable_name_of(path))]
    if len(paths) > 1:
        raise MultipleExecutables(paths)
    return paths[0] if paths else None


def run_executable(*, path: str, argv: Sequence[str], prefix: Sequence[str] | None = None) -> int:
    """Run a file with arguments, behind the words of a prefix, to its end, also through Ctrl-C; return its exit code.

    What ended it is printed unless the code is 0; below 0 it is the number of a signal.
    """
    process = subprocess.Popen([*prefixed([*(prefix or ()), path]), *argv])
    while process.returncode is None:
        try:
            process.communicate()
        except KeyboardInterrupt:
            pass  # the program has it, too, and ends
    code = process.returncode
    if code:
        print(ROS2RUN_MSG_PREFIX, described(-code) if code < 0 else f"Process exited with failure {code}")
    return code


class ExecutableNameCompleter:
    """Names of a package's executables, for argcomplete."""

    def __init__(self, *, package_name_key: str) -> None:
        self.package_name_key = package_name_key

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """The executables of the package on the command line; none if it does not exist."""
        package = getattr(parsed_args, self.package_name_key)
        try:
            return [Path(path).name for path in get_executable_paths(package_name=package)]
        except PackageNotFound:
            return []
