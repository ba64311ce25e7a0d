"""The prefixes and share directories of installed packages."""

from __future__ import annotations

import re
import warnings
from pathlib import Path

from ament_index_python.resources import get_resource, get_resources
from ament_index_python.search_paths import get_search_paths
from coursekit.processes.unavailable_packages import remark
from coursekit.systems import link_copies


class PackageNotFoundError(KeyError):
    """The package is neither in a sourced workspace nor in the underlay."""


def get_packages_with_prefixes() -> dict[str, str]:
    """Return all packages with their prefixes."""
    return get_resources("packages")


def get_package_prefix(package_name: str) -> str:
    """Return the prefix a package is installed in; raises PackageNotFoundError, or ValueError for a bad name.

    >>> get_package_prefix('nonsense')
    Traceback (most recent call last):
    ament_index_python.packages.PackageNotFoundError: "package 'nonsense' not found, searching: ...
    """
    if re.fullmatch("[a-zA-Z0-9][a-zA-Z0-9_-]+", package_name, re.ASCII) is None:
        raise ValueError(f"'{package_name}' is not a valid package name")
    try:
        prefix = get_resource("packages", package_name)[1]
    except LookupError:
        text = f"package '{package_name}' not found, searching: {get_search_paths()}"
        why = remark(package_name)
        raise PackageNotFoundError(f"{text}; {why}" if why else text) from None
    link_copies.renew(Path(prefix), package_name)
    return prefix


def get_package_share_directory(package_name: str, print_warning: bool = True) -> str:
    """Return the share directory of a package, such as <prefix>/share/turtlesim."""
    path = Path(get_package_prefix(package_name)) / "share" / package_name
    if print_warning and not path.exists():
        warnings.warn(f"Share directory for {package_name} ({path}) does not exist.", stacklevel=2)
    return str(path)


def get_package_share_path(package_name: str, print_warning: bool = True) -> Path:
    """Return the share directory of a package as a Path."""
    path = Path(get_package_share_directory(package_name, print_warning=False))
    if print_warning and not path.exists():
        warnings.warn(f"Share path for {package_name} ({path}) does not exist.", stacklevel=2)
    return path
