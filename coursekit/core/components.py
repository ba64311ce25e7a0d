"""Components: which Python executable stands for a C++ class that a container would load."""

from __future__ import annotations

import re
from pathlib import Path

from coursekit.interfaces.find import prefixes

from .executables import prefix_of


class ComponentNotFound(LookupError):
    """A package has no executable that stands for a component; the text says which were looked for."""


def registered() -> dict[str, dict[str, Path]]:
    """By package, the executables of the components that packages list in the ament index, by their class."""
    found: dict[str, dict[str, Path]] = {}
    for prefix in prefixes():
        folder = prefix / "share" / "ament_index" / "resource_index" / "rclcpp_components"
        for entry in sorted(folder.iterdir()) if folder.is_dir() else ():
            found.setdefault(entry.name, _listed(prefix, entry))
    return dict(sorted(found.items()))


def _listed(prefix: Path, entry: Path) -> dict[str, Path]:
    parts = [line.partition(";") for line in entry.read_text(encoding="utf-8").splitlines() if line.strip()]
    return {plugin: prefix / path for plugin, _, path in parts}


def candidate_names(plugin: str) -> list[str]:
    """Return the names of executables that may stand for a component.

    >>> candidate_names('demo::TalkerNode')
    ['talker_node', 'talker']
    """
    snake = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", plugin.rsplit("::", 1)[-1]).lower()
    short = snake.removesuffix("_node")
    return [snake, short] if snake.endswith("_node") else [snake, f"{snake}_node"]


def find_component(package: str, plugin: str) -> Path:
    """The executable of a component: as the package lists it, or by the name of the class.

    Raises:
        PackageNotFound: when there is no such package.
        ComponentNotFound: when the package has no such executable.
    """
    folder = prefix_of(package) / "lib" / package
    listed = registered().get(package, {}).get(plugin)
    names = candidate_names(plugin)
    for path in [*filter(None, [listed]), *(folder / name for name in names)]:
        if path.is_file() and path.suffix != ".so":
            return path
    raise ComponentNotFound(
        f"component '{plugin}' of package '{package}' is a C++ library, which cannot be loaded here; it "
        f"would run as a Python executable called {' or '.join(names)}, which the package does not have"
    )
