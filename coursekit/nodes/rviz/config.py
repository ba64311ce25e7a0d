"""A configuration of RViz: the fixed frame, the displays, the point of view. It is stored in small YAML files."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from coursekit.suggestions import did_you_mean

from .kinds import DURABILITIES, KINDS, QOS, RELIABILITIES, kind_name

_WORDS = {"reliability": RELIABILITIES, "durability": DURABILITIES}
VIEW: dict[str, Any] = {"distance": 10.0, "yaw": 0.785, "pitch": 0.785, "target": [0.0, 0.0, 0.0]}
FLAT = "TopDownOrtho"
VIEW_TYPES = ("Orbit", "ThirdPersonFollower", FLAT)
"""The known cameras of RViz: the second rotates with its target frame, the third looks straight down, as on a map."""
VIEWS = (*VIEW, "target_frame", "type")


@dataclass
class DisplayConfig:
    """One display."""

    kind: str
    topic: str = ""
    name: str = ""
    enabled: bool = True
    options: dict[str, Any] = field(default_factory=dict)
    """All options of its kind; options that were not given have their defaults"""


@dataclass
class Config:
    """A complete view; `view` holds distance [m], yaw and pitch [rad] and target [m, m, m]; None fits it to the content.

    With `target_frame` the target is in that frame and follows it; with `type` ThirdPersonFollower the yaw does, too.
    """

    fixed_frame: str = ""
    displays: list[DisplayConfig] = field(default_factory=list)
    view: dict[str, Any] | None = None
    skipped: list[str] = field(default_factory=list)
    """Displays of an .rviz file that are not known here"""
    views: dict[str, dict[str, Any]] = field(default_factory=dict)
    """Saved points of view, by name"""


def display_config(given: str | Mapping[str, Any] | DisplayConfig) -> DisplayConfig:
    """A display from 'LaserScan', 'LaserScan /scan' or {'type': 'LaserScan', 'topic': '/scan', 'size': 0.05}.

    Raises ValueError for unknown kinds and options.

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
            meant = did_you_mean(str(key), known, quotes="'", cutoff=0.5)
            there = f"There are: {', '.join(known)}." if known else "It has none."
            raise ValueError(" ".join(filter(None, [f"{kind} has no option '{key}'.", meant, there])))
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
        return numbers and all(isinstance(number, int | float) and 0 <= number <= 255 for number in value)
    return isinstance(value, str)


def make_config(
    fixed_frame: str = "",
    displays: Iterable[str | Mapping[str, Any] | DisplayConfig] = (),
    view: Any = None,
    views: Mapping[str, Any] | None = None,
) -> Config:
    """A view from its parts; raises ValueError."""
    saved = {str(name): complete for name, given in (views or {}).items() if (complete := make_view(given))}
    return Config(str(fixed_frame or ""), [display_config(display) for display in displays], make_view(view), views=saved)


def make_view(given: Any) -> dict[str, Any] | None:
    """A complete point of view; None for an empty one. Raises ValueError."""
    if not given:
        return None
    if not isinstance(given, Mapping) or any(key not in VIEWS for key in given):
        raise ValueError(f"view: {given!r} cannot be read; it may have {', '.join(VIEWS)}.")
    view: dict[str, Any] = {**VIEW, **given}
    view["target"] = [float(number) for number in view["target"]]
    if len(view["target"]) != 3 or not all(map(math.isfinite, view["target"])):
        raise ValueError(f"view: target {given['target']!r} is no point; write three numbers [m].")
    if view.get("type", "Orbit") not in VIEW_TYPES:
        raise ValueError(f"view: there is no type {view['type']!r}; there are {', '.join(VIEW_TYPES)}.")
    frame, kind = str(view.get("target_frame") or ""), view.get("type", "Orbit")
    if kind == FLAT:
        view["pitch"] = math.pi / 2
    numbers = {key: float(view[key]) for key in ("distance", "yaw", "pitch")}
    if not all(map(math.isfinite, numbers.values())):
        raise ValueError(f"view: {given!r} has a number that is none.")
    return {**numbers, "target": view["target"], **going_with(frame, kind)}


def going_with(frame: str, kind: str) -> dict[str, Any]:
    """The target frame and the camera of a view; empty for an Orbit without a target frame.

    >>> going_with("base_link", "Orbit"), going_with("", "Orbit")
    ({'target_frame': 'base_link', 'type': 'Orbit'}, {})
    """
    named = {"target_frame": frame} if frame else {}
    return {**named, "type": kind} if frame or kind == FLAT else {}


__all__ = ["FLAT", "VIEW_TYPES", "Config", "DisplayConfig", "display_config", "going_with", "make_config", "make_view"]
