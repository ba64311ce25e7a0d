"""The parameters of a costmap and its layers, with nav2's names and defaults."""

from __future__ import annotations

from typing import Any

from rclpy.node import Node

from coursekit.nav.footprint import Footprint
from coursekit.nodes.nav2.parameters import declare

COSTMAP: dict[str, Any] = {
    "always_send_full_costmap": False,
    "filters": [],
    "footprint": "[]",
    "footprint_padding": 0.01,
    "global_frame": "map",
    "height": 5,
    "width": 5,
    "lethal_cost_threshold": 100,
    "map_topic": "map",
    "origin_x": 0.0,
    "origin_y": 0.0,
    "plugins": ["static_layer", "obstacle_layer", "inflation_layer"],
    "publish_frequency": 1.0,
    "resolution": 0.1,
    "robot_base_frame": "base_link",
    "robot_radius": 0.1,
    "rolling_window": False,
    "track_unknown_space": False,
    "transform_tolerance": 0.3,
    "trinary_costmap": True,
    "update_frequency": 5.0,
    "predicted_seconds": 1.2,
}
"""`predicted_seconds` is an addition: how far ahead a rolling costmap keeps the paths of moving objects free; 0 is off."""
STATIC: dict[str, Any] = {"enabled": True, "map_subscribe_transient_local": True, "map_topic": ""}
OBSTACLES: dict[str, Any] = {"enabled": True, "footprint_clearing_enabled": True, "observation_sources": ""}
RANGES: dict[str, Any] = {
    "enabled": True, "topics": [], "clear_on_max_reading": False, "no_readings_timeout": 0.0, "phi": 1.2,
    "inflate_cone": 1.0, "clear_threshold": 0.2, "mark_threshold": 0.8, "input_sensor_type": "ALL",
}  # fmt: skip
INFLATION: dict[str, Any] = {
    "enabled": True, "cost_scaling_factor": 10.0, "inflation_radius": 0.55, "inflate_unknown": False,
}  # fmt: skip
SOURCE = {
    "topic": "",
    "data_type": "LaserScan",
    "clearing": False,
    "marking": True,
    "inf_is_valid": False,
    "obstacle_max_range": 2.5,
    "obstacle_min_range": 0.0,
    "min_obstacle_height": 0.0,
    "max_obstacle_height": 0.0,
    "raytrace_max_range": 3.0,
    "raytrace_min_range": 0.0,
}
KINDS: dict[str, tuple[str, dict[str, Any]]] = {
    "nav2_costmap_2d::StaticLayer": ("static", STATIC),
    "nav2_costmap_2d::ObstacleLayer": ("obstacles", OBSTACLES),
    "nav2_costmap_2d::VoxelLayer": ("obstacles", OBSTACLES),
    "nav2_costmap_2d::RangeSensorLayer": ("ranges", RANGES),
    "nav2_costmap_2d::InflationLayer": ("inflation", INFLATION),
}
_USUAL = {
    "static_layer": "nav2_costmap_2d::StaticLayer",
    "obstacle_layer": "nav2_costmap_2d::ObstacleLayer",
    "voxel_layer": "nav2_costmap_2d::VoxelLayer",
    "inflation_layer": "nav2_costmap_2d::InflationLayer",
}


def layers(node: Node, names: list[str]) -> list[tuple[str, str, dict[str, Any]]]:
    """Return (name, 'static', 'obstacles', 'ranges', 'inflation' or 'foreign', parameters) per layer.

    A foreign one is a C++ class, and has its `plugin` only; `KINDS` are the others' classes.
    """
    rows = []
    for name in names:
        kind = declare(node, {"plugin": _USUAL.get(name, "")}, name)["plugin"]
        what, defaults = KINDS.get(kind, ("foreign", {"plugin": kind}))
        rows.append((name, what, declare(node, defaults, name)))
    return rows


def sources(node: Node, layer: str, names: str) -> list[dict[str, Any]]:
    """Return the sensors of an obstacle layer."""
    sensors = []
    for name in names.split():
        source = declare(node, SOURCE, f"{layer}.{name}")
        source["topic"], source["name"] = source["topic"] or name, f"{layer}.{name}"
        if source["data_type"] not in ("LaserScan", "PointCloud2"):
            raise ValueError(
                f"{layer}.{name}.data_type is '{source['data_type']}': Only topics that use point cloud2s or laser scans are"
                " currently supported. Write LaserScan or PointCloud2"
            )
        sensors.append(source)
    return sensors


def footprint(given: dict[str, Any]) -> Footprint:
    """Return the robot's footprint if given, otherwise a disc. ValueError if both are invalid."""
    text = given["footprint"].strip()
    outline = Footprint.parse(text) if text not in ("", "[]") else Footprint.disc(given["robot_radius"])
    return outline.padded(given["footprint_padding"])
