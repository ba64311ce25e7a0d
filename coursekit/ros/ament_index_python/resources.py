"""Resources of the ament index: small files that describe what is installed."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from ament_index_python.constants import RESOURCE_INDEX_SUBFOLDER
from ament_index_python.search_paths import get_search_paths


class InvalidResourceTypeNameError(ValueError):
    """A resource type with a path separator in its name."""


class InvalidResourceNameError(ValueError):
    """A resource with a path separator in its name."""


def _check(resource_type: str, resource_name: str | None = None) -> None:
    assert resource_type, "The resource type must not be empty"
    assert resource_name is None or resource_name, "The resource name must not be empty"
    if "/" in resource_type or "\\" in resource_type:
        raise InvalidResourceTypeNameError(f"Resource type '{resource_type}' is invalid")
    if resource_name is not None and ("/" in resource_name or "\\" in resource_name):
        raise InvalidResourceNameError(f"Resource name '{resource_name}' is invalid")


def _folders(resource_type: str = "") -> list[tuple[str, Path]]:
    folders = [(path, Path(path) / RESOURCE_INDEX_SUBFOLDER / resource_type) for path in get_search_paths()]
    return [(path, folder) for path, folder in folders if folder.is_dir()]


def get_resource(resource_type: str, resource_name: str) -> tuple[str, str]:
    """Return the content of a resource and the prefix it is in; raises LookupError."""
    prefix = has_resource(resource_type, resource_name)
    if not prefix:
        raise LookupError(f"Could not find the resource '{resource_name}' of type '{resource_type}'")
    path = Path(prefix) / RESOURCE_INDEX_SUBFOLDER / resource_type / resource_name
    try:
        return path.read_text(encoding="utf-8"), prefix
    except OSError as error:
        what = f"Could not open the resource '{resource_name}' of type '{resource_type}'"
        raise OSError(f"{what}:\n{error}") from error


def get_resources(resource_type: str) -> dict[str, str]:
    """Return the names of all resources of a type with their prefixes (the first prefix wins)."""
    _check(resource_type)
    resources: dict[str, str] = {}
    for prefix, folder in _folders(resource_type):
        for path in sorted(folder.iterdir()):
            if not path.is_dir() and not path.name.startswith("."):
                resources.setdefault(path.name, prefix)
    return resources


def get_resource_types() -> set[str]:
    """Return the types of resources that exist."""
    return {
        path.name
        for _, folder in _folders()
        for path in folder.iterdir()
        if path.is_dir() and not path.name.startswith(".")
    }


def has_resource(resource_type: str, resource_name: str) -> str | Literal[False]:
    """Return the prefix that has a resource, or False."""
    _check(resource_type, resource_name)
    for prefix, folder in _folders(resource_type):
        if (folder / resource_name).is_file():
            return prefix
    return False
