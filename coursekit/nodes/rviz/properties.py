"""The properties of a display that can be changed, under RViz's names, with their editors on a page."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from .config import DisplayConfig, display_config
from .kinds import DURABILITIES, KINDS, QOS, RELIABILITIES

_NAMES = {"size": "Size (m)", "size_pixels": "Size (Pixels)", "tf_prefix": "TF Prefix", "covariance": "Covariance",
          "reliability": "Reliability Policy", "durability": "Durability Policy"}  # fmt: skip
_CHOICES: dict[str, tuple[str, ...]] = {
    "style": ("Points", "Flat Squares", "Boxes"),
    "color_transformer": ("", "FlatColor", "Intensity", "AxisColor", "RGB8"),
    "color_scheme": ("map", "costmap"),
    "shape": ("Arrow", "Axes"),
    "reliability": RELIABILITIES,
    "durability": DURABILITIES,
}
_WHOLE = ("depth", "keep", "plane_cell_count", "history_length", "buffer_length", "size_pixels")
_BELOW_ZERO = ("min_intensity", "max_intensity")

ABOUT = {
    "Grid": "squares on the floor",
    "RobotModel": "a robot from its description",
    "TF": "all frames and their parents",
    "Map": "an occupancy grid or costmap",
    "LaserScan": "where the beams of a LiDAR end",
    "Path": "a planned or driven path",
    "Pose": "an arrow, such as a goal",
    "PoseWithCovariance": "a pose and how sure it is",
    "PoseArray": "many small arrows",
    "Odometry": "arrows along the driven path",
    "Marker": "a shape from a program",
    "MarkerArray": "many shapes from a program",
    "PointCloud2": "points in space",
    "Image": "a camera's picture",
    "Axes": "the three axes of a frame",
    "Polygon": "an outline, such as a footprint",
    "PointStamped": "a point, such as a click",
    "GridCells": "single cells of a grid",
    "Range": "an ultrasonic sensor's cone",
    "Wrench": "a force and a torque",
    "TwistStamped": "a velocity",
    "AccelStamped": "an acceleration",
    "PointCloud": "points, in the older message",
    "ParticleCloud": "amcl's guesses of the pose",
    "Temperature": "a thermometer's reading",
    "RelativeHumidity": "a humidity sensor's reading",
    "FluidPressure": "a pressure sensor's reading",
    "Illuminance": "a light sensor's reading",
}
"""A short description of the content of each kind."""


@dataclass(frozen=True)
class Property:
    """A property that can be changed."""

    key: str
    """Its name in our configurations"""
    name: str
    """Its name in RViz"""
    editor: str
    """'box', 'colour', 'choice', 'text' or 'number'"""
    choices: tuple[str, ...] = ()
    least: float | None = None
    most: float | None = None
    whole: bool = False


def rviz_name(key: str) -> str:
    """RViz's name of an option.

    >>> rviz_name("decay_time"), rviz_name("size")
    ('Decay Time', 'Size (m)')
    """
    return _NAMES.get(key, key.replace("_", " ").title())


def properties(kind: str) -> list[Property]:
    """The properties of displays of a kind, in RViz's order: appearance first, then the topic's QoS.

    >>> [one.name for one in properties("PointStamped")][:4]
    ['Color', 'Alpha', 'Radius', 'History Length']
    """
    known = KINDS[kind]
    return [_property(key, like) for key, like in {**known.options, **(QOS if known.type else {})}.items()]


def _property(key: str, like: Any) -> Property:
    name = rviz_name(key)
    if key in _CHOICES:
        return Property(key, name, "choice", _CHOICES[key])
    if isinstance(like, bool):
        return Property(key, name, "box")
    if isinstance(like, list):
        return Property(key, name, "colour")
    if isinstance(like, str):
        return Property(key, name, "text")
    least = None if key in _BELOW_ZERO else 1.0 if key in _WHOLE else 0.0
    return Property(key, name, "number", (), least, 1.0 if key == "alpha" else None, key in _WHOLE)


def changed(display: DisplayConfig, given: Mapping[str, Any]) -> dict[str, Any]:
    """All options of a display with some of them changed; numbers stay within their bounds. Raises ValueError."""
    options = display_config({"type": display.kind, **given}).options
    bounds = {row.key: row for row in properties(display.kind)}
    return {**display.options, **{key: _within(options[key], bounds[key]) for key in given}}


def _within(value: Any, bounds: Property) -> Any:
    if bounds.editor != "number":
        return value
    value = value if bounds.least is None else max(bounds.least, value)
    value = value if bounds.most is None else min(bounds.most, value)
    return round(value) if bounds.whole else value


__all__ = ["ABOUT", "Property", "changed", "properties", "rviz_name"]
