"""What an RViz shows: the fixed frame, the displays, the point of view. Read from and written to small YAML files."""

from __future__ import annotations

import difflib
import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import yaml

from coursekit.files import read_text, write_whole

from .kinds import DURABILITIES, KINDS, QOS, RELIABILITIES, kind_name

_WORDS = {"reliability": RELIABILITIES, "durability": DURABILITIES}
VIEWS = ("distance", "yaw", "pitch", "target")


@dataclass
class DisplayConfig:
    """One display."""

    kind: str
    topic: str = ""
    name: str = ""
    enabled: bool = True
    options: dict[str, Any] = field(default_factory=dict)
    """All options of its kind, those not given at their defaults"""


@dataclass
class Config:
    """A whole view; `view` holds distance [m], yaw and pitch [rad] and target [m, m, m], None: what fits."""

    fixed_frame: str = ""
    displays: list[DisplayConfig] = field(default_factory=list)
    view: dict[str, Any] | None = None
    skipped: list[str] = field(default_factory=list)
    """Displays of an .rviz file that are not known here"""


def display_config(given: str | Mapping[str, Any] | DisplayConfig) -> DisplayConfig:
    """A display from 'LaserScan', 'LaserScan /scan' or {'type': 'LaserScan', 'topic': '/scan', 'size': 0.05}.

    Raises ValueError for kinds and options that there are not.

    >>> display_config("LaserScan /front/scan").topic
    '/front/scan'
    """
    if isinstance(given, DisplayConfig):
        return replace(given, options=dict(given.options))
    if isinstance(given, str):
        words = given.split()
        given = {"type": words[0] if words else "", **({"topic": words[1]} if len(words) > 1 else {})}
    if not isinstance(given, Mapping) or not isinstance(given.get("type"), str):
        raise ValueError(f"{given!r} is no display. Write 'LaserScan /scan' or {{'type': 'LaserScan', 'topic': '/scan'}}.")
    rest = {key: value for key, value in given.items() if key != "type"}
    name = kind_name(given["type"])
    kind = KINDS[name]
    topic = str(rest.pop("topic", kind.topic))
    if kind.type and not topic.startswith("/"):
        topic = f"/{topic}"
    shown = str(rest.pop("name", name))
    enabled = bool(rest.pop("enabled", True))
    known = {**kind.options, **QOS} if kind.type else kind.options
    return DisplayConfig(name, topic, shown, enabled, _options(name, known, rest))


def _options(kind: str, known: Mapping[str, Any], given: Mapping[str, Any]) -> dict[str, Any]:
    for key, value in given.items():
        if key not in known:
            near = difflib.get_close_matches(str(key), known, 1, 0.5)
            hint = f"Did you mean '{near[0]}'? " if near else ""
            there = f"There are: {', '.join(known)}." if known else "It has none."
            raise ValueError(f"{kind} has no option '{key}'. {hint}{there}")
        if not _fits(known[key], value):
            raise ValueError(f"{kind}: '{key}' cannot be {value!r}; it is like {known[key]!r}.")
        if value not in (allowed := _WORDS.get(key, (value,))):
            raise ValueError(f"{kind}: '{key}' cannot be {value!r}; it is one of {', '.join(allowed[1:])}.")
    return {**known, **given}


def _fits(like: Any, value: Any) -> bool:
    if isinstance(like, bool) or isinstance(value, bool):
        return isinstance(like, bool) and isinstance(value, bool)
    if isinstance(like, int | float):
        return isinstance(value, int | float) and math.isfinite(value)
    if isinstance(like, list):
        numbers = isinstance(value, list | tuple) and len(value) == 3
        return numbers and all(isinstance(one, int | float) and 0 <= one <= 255 for one in value)
    return isinstance(value, str)


def make_config(
    fixed_frame: str = "", displays: Iterable[str | Mapping[str, Any] | DisplayConfig] = (), view: Any = None
) -> Config:
    """A view from its parts; raises ValueError."""
    return Config(str(fixed_frame or ""), [display_config(one) for one in displays], _view(view))


def _view(given: Any) -> dict[str, Any] | None:
    if not given:
        return None
    if not isinstance(given, Mapping) or any(key not in VIEWS for key in given):
        raise ValueError(f"view: {given!r} cannot be read; it may have {', '.join(VIEWS)}.")
    made: dict[str, Any] = {"distance": 10.0, "yaw": 0.785, "pitch": 0.785, "target": [0.0, 0.0, 0.0], **given}
    made["target"] = [float(one) for one in made["target"]]
    return {key: value if key == "target" else float(value) for key, value in made.items()}


def read(path: str | Path, rooted: bool = True) -> Config:
    """The view in a file: ours, or one that RViz saved. Raises OSError, and ValueError which names the file.

    With `rooted` topics are absolute; else those of an .rviz file stay as written, for a node to resolve.
    """
    file = Path(path)
    try:
        data = yaml.safe_load(read_text(file))
        if not isinstance(data, dict):
            raise ValueError("it holds no mapping with 'displays:'")
        if "Visualization Manager" in data:
            from .rviz_file import from_rviz

            config = from_rviz(data)
            for one in config.displays if rooted else ():
                one.topic = one.topic if one.topic.startswith("/") or not KINDS[one.kind].type else f"/{one.topic}"
            return config
        unknown = [key for key in data if key not in ("fixed_frame", "displays", "view")]
        if unknown:
            raise ValueError(f"'{unknown[0]}' is not known; there are fixed_frame, displays and view")
        return make_config(data.get("fixed_frame", ""), data.get("displays") or [], data.get("view"))
    except (ArithmeticError, ValueError, LookupError, TypeError, AttributeError, RecursionError, yaml.YAMLError) as error:
        raise ValueError(f"{file} cannot be read as a viewer's configuration: {error}") from None


def save(config: Config, path: str | Path) -> None:
    """Write a view as small YAML: only what differs from the defaults."""
    data: dict[str, Any] = {"fixed_frame": config.fixed_frame, "displays": [_small(one) for one in config.displays]}
    if config.view:
        data["view"] = config.view
    write_whole(path, yaml.safe_dump(data, sort_keys=False, default_flow_style=None))


def _small(display: DisplayConfig) -> dict[str, Any]:
    kind = KINDS[display.kind]
    made: dict[str, Any] = {"type": display.kind}
    if kind.type:
        made["topic"] = display.topic
    if display.name != display.kind:
        made["name"] = display.name
    if not display.enabled:
        made["enabled"] = False
    return made | {key: value for key, value in display.options.items() if value != {**QOS, **kind.options}.get(key)}


__all__ = ["Config", "DisplayConfig", "display_config", "make_config", "read", "save"]
