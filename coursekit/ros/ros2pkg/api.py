"""Packages and their executables, as launch files use them."""

from __future__ import annotations

from typing import Any

from coursekit.processes import executables


class PackageNotFound(Exception):
    """The package `package_name` does not exist."""

    def __init__(self, package_name: str) -> None:
        super().__init__(package_name)
        self.package_name = package_name


def get_package_names() -> list[str]:
    """The names of all packages, sorted."""
    return list(executables.packages())


def get_prefix_path(package_name: str) -> str | None:
    """The prefix of a package; None if the package does not exist."""
    try:
        return str(executables.prefix_of(package_name))
    except executables.PackageNotFound:
        return None


def get_executable_paths(*, package_name: str) -> list[str]:
    """The files of a package's executables, sorted; raises PackageNotFound.

    >>> import os
    >>> [os.path.basename(path) for path in get_executable_paths(package_name="action_tutorials_py")]
    ['fibonacci_action_client', 'fibonacci_action_server']
    """
    try:
        return [str(path) for path in executables.executables_of(package_name)]
    except executables.PackageNotFound:
        raise PackageNotFound(package_name) from None


def package_name_completer(**_: Any) -> list[str]:
    """The names of all packages, for argcomplete."""
    return get_package_names()
