"""Components: finds the Python executable that replaces a C++ class in a container."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from coursekit.files import read_text
from coursekit.interfaces.find import prefixes
from coursekit.systems.layout import executable_files

from .executables import PackageNotFound, prefix_of
from .process import current_process

_FIRST_NODE = "what the first node is given"
_TOLD = "signals that are told of"


class ComponentNotFound(LookupError):
    """There is no executable for a component; the message begins as Humble's does and lists the available ones."""


def registered() -> dict[str, dict[str, Path]]:
    """Return the executables of components registered in the ament index, by package and class."""
    executables: dict[str, dict[str, Path]] = {}
    for prefix in prefixes():
        folder = prefix / "share" / "ament_index" / "resource_index" / "rclcpp_components"
        for entry in sorted(folder.iterdir()) if folder.is_dir() else ():
            executables.setdefault(entry.name, _listed(prefix, entry))
    return dict(sorted(executables.items()))


def _lines(entry: Path) -> list[list[str]]:
    return [line.split(";") for line in read_text(entry).splitlines() if ";" in line]


def _listed(prefix: Path, entry: Path) -> dict[str, Path]:
    return {plugin: prefix / path for plugin, path, *_library in _lines(entry)}


def library_of(path: Path, package: str, plugin: str) -> Path:
    """Return the library that the executable of a component stands for: the executable itself where there is none."""
    for prefix in prefixes():
        entry = prefix / "share" / "ament_index" / "resource_index" / "rclcpp_components" / package
        for name, program, *library in _lines(entry) if entry.is_file() else ():
            if name == plugin and library and prefix / program == path:
                return prefix / library[0]
    return path


def candidate_names(plugin: str) -> list[str]:
    """Return the names of executables that may replace a component not registered by its package.

    >>> candidate_names('demo::TalkerNode')
    ['talker_node', 'talker']
    """
    snake = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", plugin.rsplit("::", 1)[-1]).lower()
    short = snake.removesuffix("_node")
    return [snake, short] if snake.endswith("_node") else [snake, f"{snake}_node"]


def find_component(package: str, plugin: str) -> Path:
    """Return the executable of a component: as registered by the package, or derived from the class name.

    Raises:
        ComponentNotFound: when there is no such package, or it has no such executable.
    """
    try:
        folder = prefix_of(package) / "lib" / package
    except PackageNotFound as error:
        raise ComponentNotFound(f"Could not find requested resource in ament index: {error}") from None
    listed = registered().get(package, {})
    for path in [*filter(None, [listed.get(plugin)]), *_by_name(folder, plugin)]:
        if path.is_file() and path.suffix != ".so":
            return path
    raise ComponentNotFound(f"Failed to find class with the requested plugin name. {_reason(package, plugin, listed)}")


def _by_name(folder: Path, plugin: str) -> list[Path]:
    return [path for name in candidate_names(plugin) for path in executable_files(folder, name)]


def _reason(package: str, plugin: str, listed: dict[str, Path]) -> str:
    if listed and plugin not in listed:
        return f"Package '{package}' has no '{plugin}'; it has: {', '.join(listed)}"
    names = " or ".join(candidate_names(plugin))
    return (
        f"Component '{plugin}' of package '{package}' is a C++ library, which cannot be loaded here; it "
        f"would run as a Python executable called {names}, which the package does not have"
    )


@dataclass(frozen=True)
class Given:
    """The arguments for a component's node, instead of its process's: command-line words and parameters."""

    arguments: Sequence[str]
    parameters: Sequence[Any]


def give_to_first_node(process: Any, given: Given) -> None:
    """Make the first node created by a process the component's node."""
    process.locals[_FIRST_NODE] = given


def take_for_first_node() -> Given | None:
    """Return the argument of `give_to_first_node` for the calling code's process; None without one, or on a second call."""
    process = current_process()
    return None if process is None else process.locals.pop(_FIRST_NODE, None)


def share_told_signals(process: Any, told: set[int]) -> None:
    """Make a process a part of one that tells of each signal once: `told` has the signals it has told of."""
    process.locals[_TOLD] = told


def tells_of(process: Any, number: int) -> bool:
    """Return whether a process has to tell of a signal: no other part of the same process has done so."""
    told = process.locals.get(_TOLD, set())
    if number in told:
        return False
    told.add(number)
    return True
