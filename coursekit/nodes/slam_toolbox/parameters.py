"""slam_toolbox's parameters with their defaults, and their conversion for coursekit.slam."""

from __future__ import annotations

import math
from typing import Any

from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node

from coursekit.slam.parameters import SlamParameters

DEFAULTS: dict[str, Any] = {
    "odom_frame": "odom",
    "map_frame": "map",
    "base_frame": "base_footprint",
    "resolution": 0.05,
    "map_name": "/map",
    "use_map_saver": True,
    "scan_topic": "/scan",
    "scan_queue_size": 1,
    "throttle_scans": 1,
    "position_covariance_scale": 1.0,
    "yaw_covariance_scale": 1.0,
    "enable_interactive_mode": False,
    "transform_timeout": 0.5,
    "minimum_time_interval": 0.5,
    "debug_logging": False,
    "paused_new_measurements": False,
    "transform_publish_period": 0.05,
    "restamp_tf": False,
    "tf_buffer_duration": 30.0,
    "map_file_name": "",
    "map_update_interval": 10.0,
    "map_start_pose": [],
    "map_start_at_dock": False,
    "mode": "mapping",
    "max_laser_range": 25.0,
    "min_laser_range": 0.0,
    "use_scan_matching": True,
    "do_loop_closing": True,
    "minimum_travel_distance": 0.5,
    "minimum_travel_heading": 0.5,
    "loop_search_maximum_distance": 3.0,
}
"""The parameters that this node uses."""

ACCEPTED: dict[str, Any] = {
    "solver_plugin": "solver_plugins::CeresSolver",
    "ceres_linear_solver": "SPARSE_NORMAL_CHOLESKY",
    "ceres_preconditioner": "JACOBI",
    "ceres_trust_strategy": "LEVENBERG_MARQUARDT",
    "ceres_dogleg_type": "TRADITIONAL_DOGLEG",
    "ceres_loss_function": "None",
    "stack_size_to_use": 40_000_000,
    "use_scan_barycenter": True,
    "scan_buffer_size": 10,
    "scan_buffer_maximum_scan_distance": 10.0,
    "link_match_minimum_response_fine": 0.1,
    "link_scan_maximum_distance": 1.5,
    "loop_match_minimum_chain_size": 10,
    "loop_match_maximum_variance_coarse": 3.0,
    "loop_match_minimum_response_coarse": 0.35,
    "loop_match_minimum_response_fine": 0.45,
    "correlation_search_space_dimension": 0.5,
    "correlation_search_space_resolution": 0.01,
    "correlation_search_space_smear_deviation": 0.1,
    "loop_search_space_dimension": 8.0,
    "loop_search_space_resolution": 0.05,
    "loop_search_space_smear_deviation": 0.03,
    "distance_variance_penalty": 0.5,
    "angle_variance_penalty": 1.0,
    "fine_search_angle_offset": 0.00349,
    "coarse_search_angle_offset": 0.349,
    "coarse_angle_resolution": 0.0349,
    "minimum_angle_penalty": 0.9,
    "minimum_distance_penalty": 0.5,
    "use_response_expansion": True,
    "min_pass_through": 2,
    "occupancy_threshold": 0.1,
}
"""The parameters of the Karto matcher and its solver: accepted and shown, but without effect, as ours has no such part."""


LIFELONG: dict[str, Any] = {
    "lifelong_search_use_tree": False,
    "lifelong_minimum_score": 0.1,
    "lifelong_iou_match": 0.85,
    "lifelong_node_removal_score": 0.04,
    "lifelong_overlap_score_scale": 0.06,
    "lifelong_constraint_multiplier": 0.08,
    "lifelong_nearby_penalty": 0.001,
    "lifelong_candidates_scale": 0.03,
}
"""The parameters of the lifelong node: accepted and shown, but without effect, because ours keeps all scans."""


def declare(node: Node) -> None:
    """Declare all parameters; integers are accepted for real numbers, because people write them in files."""
    loose = ParameterDescriptor(dynamic_typing=True)
    for name, default in {**DEFAULTS, **ACCEPTED}.items():
        node.declare_parameter(name, default, loose)


def declare_lifelong(node: Node) -> None:
    """Declare the parameters of the lifelong node, too."""
    for name, default in LIFELONG.items():
        node.declare_parameter(name, default, ParameterDescriptor(dynamic_typing=True))


def number(node: Node, name: str, *, least: float = -math.inf) -> float:
    """A real parameter; an invalid or too small value is replaced by the default, with a warning."""
    value = node.get_parameter(name).value
    if isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value) and value >= least:
        return float(value)
    default = float(DEFAULTS[name])
    wanted = "a number" if least == -math.inf else f"a number, at least {least:g}"
    node.get_logger().warning(f"{name} should be {wanted}, not {value!r}: {default:g} is used")
    return default


def slam_parameters(node: Node) -> SlamParameters:
    """Convert the node's parameters to the library's."""
    matching = bool(node.get_parameter("use_scan_matching").value)
    loops = matching and bool(node.get_parameter("do_loop_closing").value)
    usual = SlamParameters()
    return SlamParameters(
        resolution=number(node, "resolution", least=0.001),
        range_min=max(number(node, "min_laser_range"), usual.range_min),
        keyframe_distance=number(node, "minimum_travel_distance", least=0.0),
        keyframe_angle=number(node, "minimum_travel_heading", least=0.0),
        loop_view=number(node, "loop_search_maximum_distance", least=0.0),
        loop_candidates=usual.loop_candidates if loops else 0,
        matching=matching,
    )
