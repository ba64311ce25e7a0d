"""amcl's parameters, with nav2's names and defaults, and those that exist only here."""

from __future__ import annotations

import math
from typing import Any

from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node

from coursekit.nav.particle_filter import FilterParameters

DEFAULTS: dict[str, Any] = {
    "alpha1": 0.2,
    "alpha2": 0.2,
    "alpha3": 0.2,
    "alpha4": 0.2,
    "alpha5": 0.2,
    "always_reset_initial_pose": False,
    "base_frame_id": "base_footprint",
    "beam_skip_distance": 0.5,
    "beam_skip_error_threshold": 0.9,
    "beam_skip_threshold": 0.3,
    "do_beamskip": False,
    "first_map_only": False,
    "global_frame_id": "map",
    "initial_pose.x": 0.0,
    "initial_pose.y": 0.0,
    "initial_pose.z": 0.0,
    "initial_pose.yaw": 0.0,
    "lambda_short": 0.1,
    "laser_likelihood_max_dist": 2.0,
    "laser_max_range": 100.0,
    "laser_min_range": -1.0,
    "laser_model_type": "likelihood_field",
    "map_topic": "map",
    "max_beams": 60,
    "max_particles": 2000,
    "min_particles": 500,
    "odom_frame_id": "odom",
    "pf_err": 0.05,
    "pf_z": 0.99,
    "recovery_alpha_fast": 0.0,
    "recovery_alpha_slow": 0.0,
    "resample_interval": 1,
    "robot_model_type": "nav2_amcl::DifferentialMotionModel",
    "save_pose_rate": 0.5,
    "scan_topic": "scan",
    "set_initial_pose": False,
    "sigma_hit": 0.2,
    "tf_broadcast": True,
    "transform_tolerance": 1.0,
    "update_min_a": 0.2,
    "update_min_d": 0.25,
    "z_hit": 0.5,
    "z_max": 0.05,
    "z_rand": 0.5,
    "z_short": 0.05,
    "random_seed": 0,
}
"""`random_seed` is an addition: the same seed, scans and odometry give the same particles."""
_DRIVES = {"nav2_amcl::DifferentialMotionModel": False, "nav2_amcl::OmniMotionModel": True}
_DRIVES |= {"differential": False, "omnidirectional": True}


def declare(node: Node) -> None:
    """Declare all parameters; integers are accepted for floats."""
    for name, default in DEFAULTS.items():
        node.declare_parameter(name, default, ParameterDescriptor(dynamic_typing=True))


def given(node: Node, name: str) -> Any:
    """Return a parameter: the value being requested, or the current one."""
    asked: dict[str, Any] = getattr(node, "asked_for", {})
    return asked.get(name, node.get_parameter(name).value)


def number(node: Node, name: str) -> float:
    """Return a float parameter. ValueError if it is not a number."""
    value = given(node, name)
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        raise ValueError(f"{name} should be a number, for example {DEFAULTS[name]}, not {value!r}")
    return float(value)


def filter_parameters(node: Node) -> FilterParameters:
    """Return the filter's parameters. ValueError for an invalid value."""
    drive = given(node, "robot_model_type")
    if drive not in _DRIVES:
        raise ValueError(f"unknown robot_model_type {drive!r}: use one of {', '.join(_DRIVES)}")
    model = given(node, "laser_model_type")
    if model != "likelihood_field":
        node.get_logger().warning(f"laser_model_type '{model}' is not made here: 'likelihood_field' is used")
    names = ("pf_err", "pf_z", "z_hit", "z_rand", "sigma_hit", "recovery_alpha_slow", "recovery_alpha_fast")
    whole = ("min_particles", "max_particles", "resample_interval")
    return FilterParameters(
        **{name: number(node, name) for name in names},  # type: ignore[arg-type]
        **{name: int(number(node, name)) for name in whole},  # type: ignore[arg-type]
        alphas=tuple(max(number(node, f"alpha{k}"), 0.0) for k in range(1, 6)),
        omni=_DRIVES[drive],
        seed=max(int(number(node, "random_seed")), 0),
    )
