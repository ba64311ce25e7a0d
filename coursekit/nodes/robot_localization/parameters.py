"""Parameters of the filter nodes, with Humble's names and defaults."""

from __future__ import annotations

from typing import Any

import numpy as np
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node

from coursekit.nav.fusion.control import Control
from coursekit.nav.fusion.state import SIZE, Array
from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.robot_localization.sources import Source

DEFAULTS: dict[str, Any] = {
    "frequency": 30.0,
    "two_d_mode": False,
    "transform_time_offset": 0.0,
    "transform_timeout": 0.0,
    "print_diagnostics": False,
    "publish_tf": True,
    "publish_acceleration": False,
    "permit_corrected_publication": False,
    "map_frame": "map",
    "odom_frame": "odom",
    "base_link_frame": "base_link",
    "gravitational_acceleration": 9.80665,
    "smooth_lagged_data": False,
    "history_length": 0.0,
    "reset_on_time_jump": False,
    "predict_to_current_time": False,
    "disabled_at_startup": False,
    "dynamic_process_noise_covariance": False,
    "use_control": False,
    "stamped_control": False,
    "control_timeout": 0.0,
    "debug": False,
    "debug_out_file": "robot_localization_debug.txt",
}
_SET = "use_control is set to true"
_CONTROL = ("acceleration_limits", "acceleration_gains", "deceleration_limits", "deceleration_gains")


def read(node: Node) -> dict[str, Any]:
    """Declare and read the parameters of every filter; raises ValueError if the world frame or the frequency is invalid."""
    given = declare(node, DEFAULTS)
    odom, base = given["odom_frame"], given["base_link_frame"]
    if not given["frequency"] > 0:
        raise ValueError(f"frequency is {given['frequency']}: give Hz, for example 30.0")
    more = {"world_frame": odom, "base_link_frame_output": base, "sensor_timeout": 1.0 / given["frequency"]}
    given |= declare(node, more)
    if len({given["map_frame"], odom, base}) < 3 or given["base_link_frame_output"] in (given["map_frame"], odom):
        node.get_logger().error(
            "Invalid frame configuration! The values for map_frame, odom_frame, and base_link_frame must be unique. "
            "If using a base_link_frame_output values, it must not match the map_frame or odom_frame."
        )
    if given["world_frame"] not in (given["map_frame"], odom):
        raise ValueError(f"world_frame is '{given['world_frame']}': give the name in map_frame or in odom_frame")
    return given


def optional(node: Node, name: str) -> list[float] | None:
    """A parameter that is a list of numbers without a default; None if it is not given."""
    if not node.has_parameter(name):
        node.declare_parameter(name, descriptor=ParameterDescriptor(dynamic_typing=True))
    value = node.get_parameter(name).value
    return None if value is None else [float(number) for number in value]


def covariance(node: Node, name: str) -> Array | None:
    """A matrix of 15 by 15, given row by row or by its diagonal; None when it is not given."""
    flat = optional(node, name)
    if flat is None:
        return None
    if len(flat) == SIZE:
        return np.diag(flat)
    if len(flat) != SIZE * SIZE:
        raise ValueError(f"{name} has {len(flat)} numbers: give the 15 of the diagonal, or all 225 row by row")
    return np.array(flat).reshape(SIZE, SIZE)


def control(node: Node, given: dict[str, Any], sources: list[Source]) -> Control | None:
    """The commanded velocity; None without use_control, or if its parameters are unusable."""
    if not given["use_control"]:
        return None
    log, config = node.get_logger(), optional(node, "control_config")
    if config is None or len(config) != 6:
        log.error(f"{_SET}, but control_config is missing or has not 6 values. No control term will be used.")
        return None
    used = np.array(config, bool)
    for source in sources:
        used[:3] &= ~source.part("acceleration")[12:15]  # a measured acceleration needs no prediction
    if not used.any():
        log.error(f"{_SET}, but control_config has only false values. No control term will be used.")
        return None
    lists = {name: optional(node, name) for name in _CONTROL}
    speeding = lists["acceleration_limits"] or [1.0] * 6, lists["acceleration_gains"] or [1.0] * 6
    slowing = lists["deceleration_limits"] or speeding[0], lists["deceleration_gains"] or speeding[1]
    for name, limits in zip(_CONTROL, (*speeding, *slowing), strict=True):
        if len(limits) != 6:
            raise ValueError(f"{name} has {len(limits)} numbers: give 6, for vx, vy, vz, vroll, vpitch, vyaw")
    timeout = round(given["control_timeout"] * 1e9)
    faster, slower = np.array(speeding), np.array(slowing)
    return Control(used, timeout, faster[0], faster[1], slower[0], slower[1])
