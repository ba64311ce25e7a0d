"""The controller server's plugins, by the parameters of nav2's own."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from rclpy.node import Node

from coursekit.nav.checkers import GoalChecker, ProgressChecker
from coursekit.nav.controller import Controller, Limits
from coursekit.nodes.nav2.costmap_node import CostmapNode
from coursekit.nodes.nav2.parameters import declare

SERVER: dict[str, Any] = {
    "controller_frequency": 20.0,
    "controller_plugins": ["FollowPath"],
    "failure_tolerance": 0.0,
    "goal_checker_plugins": ["goal_checker"],
    "min_theta_velocity_threshold": 0.0001,
    "min_x_velocity_threshold": 0.0001,
    "min_y_velocity_threshold": 0.0001,
    "odom_topic": "odom",
    "progress_checker_plugin": "progress_checker",
    "speed_limit_topic": "speed_limit",
}
_GOAL = {
    "plugin": "nav2_controller::SimpleGoalChecker",
    "xy_goal_tolerance": 0.25,
    "yaw_goal_tolerance": 0.25,
    "stateful": True,
}
_PROGRESS = {
    "plugin": "nav2_controller::SimpleProgressChecker", "required_movement_radius": 0.5, "movement_time_allowance": 10.0,
}  # fmt: skip
_DWB: dict[str, Any] = {
    "min_vel_x": 0.0,
    "max_vel_x": 0.26,
    "max_vel_theta": 1.0,
    "acc_lim_x": 2.5,
    "decel_lim_x": -2.5,
    "acc_lim_theta": 3.2,
    "vx_samples": 20,
    "vtheta_samples": 20,
    "sim_time": 1.7,
    "BaseObstacle.scale": 0.02,
    "PathAlign.scale": 32.0,
    "PathAlign.forward_point_distance": 0.1,
    "GoalAlign.scale": 24.0,
    "PathDist.scale": 32.0,
    "GoalDist.scale": 24.0,
}
_PURSUIT: dict[str, Any] = {
    "desired_linear_vel": 0.5,
    "max_angular_accel": 3.2,
    "rotate_to_heading_angular_vel": 1.8,
    "rotate_to_heading_min_angle": 0.785,
}
_DWB_NAME, _SHIM = "dwb_core::DWBLocalPlanner", "nav2_rotation_shim_controller::RotationShimController"
_PURSUIT_NAME = "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController"


def controller(node: Node, name: str, costmap: CostmapNode, period: float) -> Controller:
    """A controller by its plugin's name: all are made by the same sampling of speeds, with the limits that they name."""
    kind = declare(node, {"plugin": _DWB_NAME}, name)["plugin"]
    if kind == _SHIM:
        kind = declare(node, {"primary_controller": _DWB_NAME}, name)["primary_controller"]
    if kind not in (_DWB_NAME, _PURSUIT_NAME):
        raise ValueError(f"{name}.plugin is '{kind}': use one of {_DWB_NAME}, {_PURSUIT_NAME}, {_SHIM}")
    given = declare(node, _DWB if kind == _DWB_NAME else _PURSUIT, name)
    made = _of_dwb(given) if kind == _DWB_NAME else _of_pursuit(given)
    made.footprint, made.period = costmap.robot, period
    layer = costmap.layers.inflation or {"inflation_radius": 0.0, "cost_scaling_factor": 10.0}
    made.scaling = layer["inflation_radius"], layer["cost_scaling_factor"]
    return made


def _of_dwb(given: dict[str, Any]) -> Controller:
    limits = Limits(
        given["min_vel_x"], given["max_vel_x"], given["max_vel_theta"], given["acc_lim_x"],
        abs(given["decel_lim_x"]), given["acc_lim_theta"],
    )  # fmt: skip
    # nav2 counts cells and scales by half a cell: 32 there is 16 a metre here
    pulls = [given[f"{critic}.scale"] / 2 for critic in ("PathDist", "GoalDist", "PathAlign", "GoalAlign")]
    weights = (*pulls, given["BaseObstacle.scale"], given["PathAlign.forward_point_distance"])
    return Controller(
        limits, horizon=given["sim_time"], speeds=given["vx_samples"], turns=given["vtheta_samples"], weights=weights  # type: ignore[arg-type]
    )  # fmt: skip


def _of_pursuit(given: dict[str, Any]) -> Controller:
    turn = given["rotate_to_heading_angular_vel"]
    limits = Limits(0.0, given["desired_linear_vel"], turn, turn_acceleration=given["max_angular_accel"])
    return Controller(limits, turn_first=given["rotate_to_heading_min_angle"])


def goal_checkers(node: Node, names: Iterable[str]) -> dict[str, GoalChecker]:
    """The goal checkers by their names."""
    given = {name: declare(node, _GOAL, name) for name in names}
    return {
        name: GoalChecker(one["xy_goal_tolerance"], one["yaw_goal_tolerance"], one["stateful"])
        for name, one in given.items()
    }


def progress_checker(node: Node, name: str) -> ProgressChecker:
    """The progress checker."""
    given = declare(node, _PROGRESS, name)
    return ProgressChecker(given["required_movement_radius"], given["movement_time_allowance"])
