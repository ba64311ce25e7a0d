"""Files with a view: small YAML files of our own, or files that RViz saved."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import yaml

from coursekit.files import read_text, write_whole

from .config import Config, DisplayConfig, make_config
from .kinds import KINDS, QOS
from .rviz_file import from_rviz
from .rviz_saving import to_rviz


def read(path: str | Path, rooted: bool = True) -> Config:
    """The view in a file of our own, or in a file that RViz saved. Raises OSError, and ValueError with the file's name.

    With `rooted`, topics are absolute; else those of an .rviz file stay as written, for a node to resolve.
    """
    file = Path(path)
    try:
        data = yaml.safe_load(read_text(file))
        if not isinstance(data, dict):
            raise ValueError("it holds no mapping with 'displays:'")
        if "Visualization Manager" in data:
            config = from_rviz(data)
            for display in config.displays if rooted else ():
                if KINDS[display.kind].type and not display.topic.startswith("/"):
                    display.topic = f"/{display.topic}"
            return config
        unknown = [key for key in data if key not in ("fixed_frame", "displays", "view", "views")]
        if unknown:
            raise ValueError(f"'{unknown[0]}' is not known; there are fixed_frame, displays, view and views")
        return make_config(data.get("fixed_frame", ""), data.get("displays") or [], data.get("view"), data.get("views"))
    except (ArithmeticError, ValueError, LookupError, TypeError, AttributeError, RecursionError, yaml.YAMLError) as error:
        raise ValueError(f"{file} cannot be read as a viewer's configuration: {error}") from None


def save(config: Config, path: str | Path) -> None:
    """Write a view: to an .rviz file as RViz does, else as small YAML with the differences from the defaults."""
    if Path(path).suffix == ".rviz":
        write_whole(path, yaml.safe_dump(to_rviz(config), sort_keys=False))
        return
    data: dict[str, Any] = {"fixed_frame": config.fixed_frame, "displays": [_small(display) for display in config.displays]}
    if config.view:
        data["view"] = config.view
    if config.views:
        data["views"] = config.views
    write_whole(path, yaml.safe_dump(data, sort_keys=False, default_flow_style=None))


def _small(display: DisplayConfig) -> dict[str, Any]:
    kind = KINDS[display.kind]
    entry: dict[str, Any] = {"type": display.kind}
    if kind.type:
        entry["topic"] = display.topic
    if display.name != display.kind:
        entry["name"] = display.name
    if not display.enabled:
        entry["enabled"] = False
    return entry | {key: value for key, value in display.options.items() if value != {**QOS, **kind.options}.get(key)}


__all__ = ["read", "save"]
