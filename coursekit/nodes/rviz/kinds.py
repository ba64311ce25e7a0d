"""The kinds of displays: the type of their messages, their default topic, and their options."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from coursekit.suggestions import did_you_mean


@dataclass(frozen=True)
class Kind:
    """The options of a display in a configuration; they have RViz's names in lower case with underscores."""

    type: str = ""
    """The type of its messages; '' if it needs no topic"""
    topic: str = ""
    options: dict[str, Any] = field(default_factory=dict)
    lasting: bool = False
    """Whether it requests the last message from before it subscribed (transient local)"""


_ARROW: dict[str, Any] = {"color": [255, 25, 0], "alpha": 1.0, "shape": "Arrow", "shaft_length": 1.0, "head_length": 0.3,
          "shaft_radius": 0.05, "head_radius": 0.1}  # fmt: skip
_POINTS: dict[str, Any] = {"size": 0.02, "size_pixels": 3, "alpha": 1.0, "color": [255, 255, 255], "color_transformer": "",
           "decay_time": 0.0, "style": "Flat Squares"}  # fmt: skip
_COVARIANCE = {"covariance": True, "axes_length": 1.0, "axes_radius": 0.1}
_SCREW = {"alpha": 1.0, "arrow_width": 0.5, "hide_small_values": True, "history_length": 1}
_TWIST = {**_SCREW, "linear_color": [204, 51, 51], "angular_color": [204, 204, 51], "linear_arrow_scale": 1.0,
          "angular_arrow_scale": 1.0}  # fmt: skip
_WRENCH = {**_SCREW, "force_color": [204, 51, 51], "torque_color": [204, 204, 51], "force_arrow_scale": 2.0,
           "torque_arrow_scale": 2.0}  # fmt: skip


def _reading(low: float, high: float) -> dict[str, Any]:
    return {"size": 0.05, "alpha": 1.0, "min_intensity": low, "max_intensity": high}


QOS: dict[str, Any] = {"reliability": "", "durability": "", "depth": 5}
"""The options of every display with a topic; '' is compatible with every publisher of its kind"""
RELIABILITIES = ("", "Reliable", "Best Effort", "System Default")
DURABILITIES = ("", "Volatile", "Transient Local", "System Default")

KINDS: dict[str, Kind] = {
    "Grid": Kind(
        options={"cell_size": 1.0, "plane_cell_count": 10, "color": [160, 160, 164], "alpha": 0.5, "reference_frame": ""}
    ),
    "RobotModel": Kind(
        "std_msgs/msg/String",
        "/robot_description",
        {"tf_prefix": "", "visual_enabled": True, "collision_enabled": False, "alpha": 1.0},
        lasting=True,
    ),
    "TF": Kind(
        options={"marker_scale": 1.0, "show_names": True, "show_axes": True, "show_arrows": True, "frame_timeout": 15.0}
    ),
    "Map": Kind("nav_msgs/msg/OccupancyGrid", "/map", {"alpha": 0.7, "color_scheme": "map"}, lasting=True),
    "LaserScan": Kind("sensor_msgs/msg/LaserScan", "/scan", {**_POINTS, "size": 0.03, "color": [230, 60, 40]}),
    "Path": Kind(
        "nav_msgs/msg/Path", "/plan", {"color": [40, 160, 90], "alpha": 1.0, "line_width": 0.02, "buffer_length": 1}
    ),
    "Pose": Kind("geometry_msgs/msg/PoseStamped", "/goal_pose", {**_ARROW, "axes_length": 1.0, "axes_radius": 0.1}),
    "PoseWithCovariance": Kind(
        "geometry_msgs/msg/PoseWithCovarianceStamped", "/amcl_pose", {**_ARROW, **_COVARIANCE}
    ),
    "PoseArray": Kind(
        "geometry_msgs/msg/PoseArray", "/particlecloud", {"color": [255, 25, 0], "alpha": 1.0, "arrow_length": 0.3}
    ),
    "Odometry": Kind(
        "nav_msgs/msg/Odometry",
        "/odom",
        {**_ARROW, "keep": 100, "position_tolerance": 0.1, "angle_tolerance": 0.1, "shaft_length": 0.4,
         "head_length": 0.12, "shaft_radius": 0.02, "head_radius": 0.05, **_COVARIANCE, "covariance": False},
    ),
    "Marker": Kind("visualization_msgs/msg/Marker", "/visualization_marker"),
    "MarkerArray": Kind("visualization_msgs/msg/MarkerArray", "/visualization_marker_array"),
    "PointCloud2": Kind("sensor_msgs/msg/PointCloud2", "/points", _POINTS),
    "Image": Kind("sensor_msgs/msg/Image", "/image"),
    "Axes": Kind(options={"length": 1.0, "radius": 0.1, "alpha": 1.0, "reference_frame": ""}),
    "Polygon": Kind("geometry_msgs/msg/PolygonStamped", "/footprint", {"color": [25, 255, 0], "alpha": 1.0}),
    "PointStamped": Kind(
        "geometry_msgs/msg/PointStamped",
        "/clicked_point",
        {"color": [204, 41, 204], "alpha": 1.0, "radius": 0.2, "history_length": 1},
    ),
    "GridCells": Kind("nav_msgs/msg/GridCells", "/cells", {"color": [25, 255, 0], "alpha": 1.0}),
    "Range": Kind("sensor_msgs/msg/Range", "/range", {"color": [255, 255, 255], "alpha": 0.5, "buffer_length": 1}),
    "Wrench": Kind("geometry_msgs/msg/WrenchStamped", "/wrench", _WRENCH),
    "TwistStamped": Kind("geometry_msgs/msg/TwistStamped", "/twist", _TWIST),
    "AccelStamped": Kind("geometry_msgs/msg/AccelStamped", "/accel", _TWIST),
    "PointCloud": Kind("sensor_msgs/msg/PointCloud", "/points", _POINTS),
    "ParticleCloud": Kind(
        "nav2_msgs/msg/ParticleCloud",
        "/particle_cloud",
        {"color": [0, 180, 0], "alpha": 1.0, "min_arrow_length": 0.02, "max_arrow_length": 0.3},
    ),
    "Temperature": Kind("sensor_msgs/msg/Temperature", "/temperature", _reading(0.0, 100.0)),
    "RelativeHumidity": Kind("sensor_msgs/msg/RelativeHumidity", "/humidity", _reading(0.0, 1.0)),
    "FluidPressure": Kind("sensor_msgs/msg/FluidPressure", "/pressure", _reading(98000.0, 105000.0)),
    "Illuminance": Kind("sensor_msgs/msg/Illuminance", "/illuminance", _reading(0.0, 1000.0)),
}  # fmt: skip
"""The kinds by RViz's names."""

ALIASES = {"PoseStamped": "Pose", "OccupancyGrid": "Map", "Robot": "RobotModel", "Camera": "Image",
           "PoseWithCovarianceStamped": "PoseWithCovariance", "PolygonStamped": "Polygon", "WrenchStamped": "Wrench"}
"""Other names that are accepted: those of the messages."""


def kind_name(name: str) -> str:
    """RViz's name of a kind; raises ValueError, which lists the known kinds.

    >>> kind_name("rviz_default_plugins/LaserScan"), kind_name("PoseStamped")
    ('LaserScan', 'Pose')
    """
    short = name.rpartition("/")[2]
    short = ALIASES.get(short, short)
    if short not in KINDS:
        meant = did_you_mean(short, KINDS, quotes="'", cutoff=0.5)
        there = f"There are: {', '.join(KINDS)}."
        raise ValueError(" ".join(filter(None, [f"There is no display '{name}'.", meant, there])))
    return short


__all__ = ["ALIASES", "DURABILITIES", "KINDS", "QOS", "RELIABILITIES", "Kind", "kind_name"]
