"""Entry points of the packages on Python's path, with which a package adds commands and verbs."""

from __future__ import annotations

import importlib.metadata
import sys
from collections.abc import Sequence
from typing import Any

from coursekit.processes.executables import python_folders
from coursekit.processes.process import current_process

EXTENSION_POINT_GROUP_NAME = "ros2cli.extension_point"


def get_all_entry_points() -> dict[str, dict[str, tuple[Any, Any]]]:
    """The distribution and the entry point of each name in each group that is an extension point."""
    points = [*get_entry_points(EXTENSION_POINT_GROUP_NAME), EXTENSION_POINT_GROUP_NAME]
    entries_by_group = {
        group: {name: (point.dist, point) for name, point in get_entry_points(group).items()} for group in points
    }
    return {group: entries for group, entries in entries_by_group.items() if entries}


def get_entry_points(group_name: str) -> dict[str, Any]:
    """The entry points of a group by name, from the workspaces sourced in the program's environment."""
    process = current_process()
    folders = [] if process is None else python_folders(process.env)
    distributions = importlib.metadata.distributions(path=folders)
    points = [point for each in distributions for point in each.entry_points if point.group == group_name]
    return {point.name: point for point in reversed(points)}  # the first folder on the path wins


def load_entry_points(group_name: str, *, exclude_names: Sequence[str] | None = None) -> dict[str, Any]:
    """The objects of a group's entry points, by name. Failures are reported and left out."""
    loaded = {}
    for name, entry_point in get_entry_points(group_name).items():
        if name in (exclude_names or ()):
            continue
        try:
            loaded[name] = entry_point.load()
        except Exception as error:
            where = f"Failed to load entry point '{name}' of group '{group_name}'"
            print(f"{where}: {error!r}. Is its module in the package, and was it built?", file=sys.stderr)
    return loaded
