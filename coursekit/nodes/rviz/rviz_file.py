"""Files that RViz 2 saved: known displays are imported, the names of the others are kept."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

from .config import FLAT, VIEW_TYPES, Config, DisplayConfig, display_config, make_view
from .kinds import KINDS, QOS, kind_name
from .rviz_saving import FIXED, SCALE

MOST_DISPLAYS = 500
_RENAMED = {"size_(m)": "size", "size_(pixels)": "size_pixels"}


def from_rviz(data: Mapping[str, Any]) -> Config:
    """The view of a parsed .rviz file."""
    manager = data.get("Visualization Manager") or {}
    config = Config(str((manager.get("Global Options") or {}).get("Fixed Frame", "") or ""))
    for entry in _flat(manager.get("Displays") or []):
        display = _display(entry)
        if display is None:
            config.skipped.append(f"{entry.get('Name', '?')} ({entry.get('Class', '?')})")
        else:
            config.displays.append(display)
    views = manager.get("Views") or {}
    config.view = _view(views.get("Current") or {})
    for entry in (views.get("Saved") or [])[:MOST_DISPLAYS]:
        if isinstance(entry, Mapping) and (view := _view(entry)):
            config.views[str(entry.get("Name", "saved view"))] = view
    return config


def _flat(entries: Any) -> list[Mapping[str, Any]]:
    """The displays, including those in groups; displays in a disabled group are disabled."""
    flat: list[Mapping[str, Any]] = []
    waiting, count = [(entry, True) for entry in reversed(entries)], 0
    while waiting:
        entry, on = waiting.pop()
        count += 1
        if count + len(waiting) > MOST_DISPLAYS:
            raise ValueError(f"it has more than {MOST_DISPLAYS} displays")
        if not isinstance(entry, Mapping):
            continue
        on = on and bool(entry.get("Enabled", True))
        if str(entry.get("Class", "")).endswith("/Group"):
            waiting += [(display, on) for display in reversed(entry.get("Displays") or [])]
        else:
            flat.append({**entry, "Enabled": on})
    return flat


def _display(entry: Mapping[str, Any]) -> DisplayConfig | None:
    try:
        kind = kind_name(str(entry.get("Class", "")))
    except ValueError:
        return None
    given: dict[str, Any] = {"type": kind, "name": str(entry.get("Name", kind))}
    given["enabled"] = bool(entry.get("Enabled", True))
    topic = entry.get("Description Topic") if kind == "RobotModel" else entry.get("Topic")
    if isinstance(topic, Mapping):
        _take_quality(given, kind, topic)
        topic = topic.get("Value")
    for key, value in _options(entry):
        _take(given, kind, str(key).lower().replace(" ", "_"), value)
    display = display_config(given)
    if topic:
        display.topic = str(topic)
    return display


def _options(entry: Mapping[str, Any]) -> Iterator[tuple[Any, Any]]:
    """Yield names and values; Odometry has those of its shape one level deeper."""
    for key, value in entry.items():
        if key == "Shape" and isinstance(value, Mapping):
            yield "shape", value.get("Value")
            yield from value.items()
        elif key == "Covariance" and isinstance(value, Mapping):
            yield "covariance", value.get("Value")
        else:
            yield key, value


def _take_quality(given: dict[str, Any], kind: str, topic: Mapping[str, Any]) -> None:
    """Import the QoS of a topic; a RobotModel always requests the last description, as in RViz."""
    _take(given, kind, "depth", topic.get("Depth"))
    if kind != "RobotModel":
        _take(given, kind, "reliability", topic.get("Reliability Policy"))
        _take(given, kind, "durability", topic.get("Durability Policy"))


def _take(given: dict[str, Any], kind: str, key: str, value: Any) -> None:
    """Import an option, if it is known and valid."""
    key = _RENAMED.get(key, key)
    like = {**QOS, **KINDS[kind].options}.get(key)
    if like is None or value is None:
        return
    if isinstance(like, list) and isinstance(value, str):
        value = [int(word) for word in value.split(";") if word.strip().isdigit()]
    if key == "reference_frame" and value == "<Fixed Frame>":
        value = ""
    try:
        display_config({"type": kind, key: value})
    except ValueError:
        return
    given[key] = value


def _view(current: Mapping[str, Any]) -> dict[str, Any] | None:
    """Convert a point of view; None if values are missing or invalid."""
    try:
        focus = current.get("Focal Point") or {}
        kind = str(current.get("Class", "")).rpartition("/")[2]
        given: dict[str, Any] = {"target": [float(focus.get(axis, 0.0)) for axis in "XYZ"]}
        if kind == FLAT:
            given["target"] = [float(current.get(axis, 0.0)) for axis in "XY"] + [0.0]
            distance = SCALE / max(1e-3, float(current.get("Scale", 10.0)))
            given |= {"distance": distance, "yaw": float(current.get("Angle", 0.0)) - math.pi / 2}
        else:
            given |= {key.lower(): float(current[key]) for key in ("Distance", "Yaw", "Pitch")}
        frame = str(current.get("Target Frame") or FIXED)
        follows = {"target_frame": "" if frame == FIXED else frame, "type": kind if kind in VIEW_TYPES else "Orbit"}
        return make_view({**given, **follows})
    except (KeyError, TypeError, ValueError, AttributeError):
        return None


__all__ = ["from_rviz"]
