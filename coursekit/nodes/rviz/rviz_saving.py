"""A view in RViz 2's file format: the displays, the fixed frame and the points of view of an .rviz file."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from .config import FLAT, Config, DisplayConfig
from .kinds import KINDS, QOS
from .properties import rviz_name

_PLUGINS = {"ParticleCloud": "nav2_rviz_plugins"}
_STEEPEST = math.pi / 2 - 0.001
"""The steepest pitch [rad]: RViz's cameras do not look straight down."""
_SHAPED = ("alpha", "color", "axes_length", "axes_radius", "head_length", "head_radius", "shaft_length", "shaft_radius")
FIXED = "<Fixed Frame>"
SCALE = 600.0
"""Pixels per metre at a distance of one metre: RViz's window is about 500 pixels high, the cameras here cover 45 degrees."""


def to_rviz(config: Config) -> dict[str, Any]:
    """The content of the file, which Humble's `rviz2 -d` and `config_file.read` can read."""
    frame = {"Fixed Frame": config.fixed_frame or "map", "Frame Rate": 30}
    views = {"Current": _view(config.view or {}, "Current View"),
             "Saved": [_view(view, name) for name, view in config.views.items()] or None}  # fmt: skip
    manager = {
        "Class": "",
        "Displays": [_display(display) for display in config.displays],
        "Enabled": True,
        "Global Options": frame,
        "Name": "root",
        "Tools": [{"Class": f"rviz_default_plugins/{tool}"} for tool in _TOOLS],
        "Value": True,
        "Views": views,
    }
    return {"Panels": [{"Class": "rviz_common/Displays", "Name": "Displays"}], "Visualization Manager": manager}


_TOOLS = ("Interact", "MoveCamera", "Select", "FocusCamera", "Measure", "SetInitialPose", "SetGoal", "PublishPoint")


def _display(display: DisplayConfig) -> dict[str, Any]:
    kind = KINDS[display.kind]
    entry: dict[str, Any] = {
        "Class": f"{_PLUGINS.get(display.kind, 'rviz_default_plugins')}/{display.kind}",
        "Name": display.name,
        "Enabled": display.enabled,
        "Value": display.enabled,
    }
    if kind.type:
        where = "Description Topic" if display.kind == "RobotModel" else "Topic"
        entry |= {where: _topic(display)} | ({"Description Source": "Topic"} if display.kind == "RobotModel" else {})
    options = {key: value for key, value in display.options.items() if key not in QOS}
    if display.kind == "Odometry":
        entry["Shape"] = {"Value": options.pop("shape")} | {rviz_name(key): _value(options.pop(key)) for key in _SHAPED}
    if "covariance" in options:
        entry["Covariance"] = {"Value": options.pop("covariance")}
    if "reference_frame" in options:
        options["reference_frame"] = options["reference_frame"] or FIXED
    if not options.get("color_transformer", "set"):
        del options["color_transformer"]  # RViz chooses by the cloud's fields
    return entry | {rviz_name(key): _value(value) for key, value in options.items()}


def _topic(display: DisplayConfig) -> dict[str, Any]:
    """A topic with its QoS; where none was given, the QoS that is requested by default."""
    lasting = KINDS[display.kind].lasting
    return {
        "Value": display.topic,
        "Depth": int(display.options["depth"]),
        "Durability Policy": display.options["durability"] or ("Transient Local" if lasting else "Volatile"),
        "History Policy": "Keep Last",
        "Reliability Policy": display.options["reliability"] or ("Reliable" if lasting else "Best Effort"),
    }


def _value(value: Any) -> Any:
    """A colour in RViz's format: three numbers in a text; other values unchanged."""
    return "; ".join(f"{round(number)}" for number in value) if isinstance(value, list | tuple) else value


def _view(view: Mapping[str, Any], name: str) -> dict[str, Any]:
    x, y, z = view.get("target", (0.0, 0.0, 0.0))
    kind = view.get("type", "Orbit")
    distance, yaw = view.get("distance", 10.0), view.get("yaw", 0.785)
    if kind == FLAT:
        seen = {"Scale": SCALE / distance, "Angle": yaw + math.pi / 2, "X": x, "Y": y}
    else:
        pitch = max(-_STEEPEST, min(_STEEPEST, view.get("pitch", 0.785)))
        seen = {"Distance": distance, "Yaw": yaw, "Pitch": pitch, "Focal Point": {"X": x, "Y": y, "Z": z}}
    frame = view.get("target_frame") or FIXED
    return {"Class": f"rviz_default_plugins/{kind}", "Name": name, "Target Frame": frame, **seen, "Value": f"{kind} (rviz)"}


__all__ = ["FIXED", "SCALE", "to_rviz"]
