"""The controller server's plugins, with the parameters of nav2."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import Any

from rclpy.node import Node

from coursekit.nav.checkers import GoalChecker, ProgressChecker
from coursekit.nav.controller import Controller, Limits
from coursekit.nodes.nav2.costmap_node import CostmapNode
from coursekit.nodes.nav2.cpp_controller import CppController, CppGoalChecker, CppProgressChecker
from coursekit.nodes.nav2.cpp_plugins import CppPlugins
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
_GOAL_KINDS = ("nav2_controller::SimpleGoalChecker", "nav2_controller::StoppedGoalChecker")
_GOAL_KIND = {"plugin": _GOAL_KINDS[0]}
_GOAL = {
    "xy_goal_tolerance": 0.25,
    "yaw_goal_tolerance": 0.25,
    "stateful": True,
}
_STOPPED = {"trans_stopped_velocity": 0.25, "rot_stopped_velocity": 0.25}
_PROGRESS_KINDS = ("nav2_controller::SimpleProgressChecker", "nav2_controller::PoseProgressChecker")
_PROGRESS_KIND = {"plugin": _PROGRESS_KINDS[0]}
_PROGRESS = {"required_movement_radius": 0.5, "movement_time_allowance": 10.0}
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
_MPPI: dict[str, Any] = {
    "vx_max": 0.5,
    "vx_min": -0.35,
    "wz_max": 1.9,
    "time_steps": 56,
    "model_dt": 0.05,
}
_SHIM_ANGLE = {"angular_dist_threshold": 0.785, "rotate_to_heading_angular_vel": 1.8, "max_angular_accel": 3.2}
_DWB_NAME, _SHIM = "dwb_core::DWBLocalPlanner", "nav2_rotation_shim_controller::RotationShimController"
_PURSUIT_NAME = "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController"
_MPPI_NAME = "nav2_mppi_controller::MPPIController"


def controller(
    node: Node, name: str, costmap: CostmapNode, period: float, foreign: CppPlugins
) -> Controller | CppController:
    """Create a controller by its plugin name. Those in Python sample velocities in the same way, within their own limits."""
    kind = plugin = declare(node, {"plugin": _DWB_NAME}, name)["plugin"]
    turn_first = None
    if kind == _SHIM:
        kind = declare(node, {"primary_controller": _DWB_NAME}, name)["primary_controller"]
        turn_first = declare(node, _SHIM_ANGLE, name)["angular_dist_threshold"]
    if kind not in _MAKERS:
        return foreign.get(CppController, name, kind, [*_MAKERS, _SHIM])
    foreign.log_created(CppController, name, plugin)
    make, defaults = _MAKERS[kind]
    own_controller = make(declare(node, defaults, name))
    own_controller.turn_first, own_controller.period = turn_first or own_controller.turn_first, period
    fit(own_controller, costmap)
    return own_controller


def fit(one: Controller, costmap: CostmapNode) -> None:
    """Set a controller's footprint and its inflation parameters from the costmap."""
    layer = costmap.layers.inflation or {"inflation_radius": 0.0, "cost_scaling_factor": 10.0}
    one.footprint, one.scaling = costmap.robot, (layer["inflation_radius"], layer["cost_scaling_factor"])


def _of_dwb(given: dict[str, Any]) -> Controller:
    limits = Limits(
        given["min_vel_x"], given["max_vel_x"], given["max_vel_theta"], given["acc_lim_x"],
        abs(given["decel_lim_x"]), given["acc_lim_theta"],
    )  # fmt: skip
    # nav2 counts cells and scales by half a cell: 32 there is 16 per metre here
    pulls = [given[f"{critic}.scale"] / 2 for critic in ("PathDist", "GoalDist", "PathAlign", "GoalAlign")]
    weights = (*pulls, given["BaseObstacle.scale"], given["PathAlign.forward_point_distance"])
    return Controller(
        limits, horizon=given["sim_time"], speeds=given["vx_samples"], turns=given["vtheta_samples"], weights=weights  # type: ignore[arg-type]
    )  # fmt: skip


def _of_pursuit(given: dict[str, Any]) -> Controller:
    turn = given["rotate_to_heading_angular_vel"]
    limits = Limits(0.0, given["desired_linear_vel"], turn, turn_acceleration=given["max_angular_accel"])
    return Controller(limits, turn_first=given["rotate_to_heading_min_angle"])


def _of_mppi(given: dict[str, Any]) -> Controller:
    limits = Limits(0.0, given["vx_max"], given["wz_max"])
    return Controller(limits, horizon=min(given["time_steps"] * given["model_dt"], 2.0))


_MAKERS: dict[str, tuple[Callable[[dict[str, Any]], Controller], dict[str, Any]]] = {
    _DWB_NAME: (_of_dwb, _DWB),
    _PURSUIT_NAME: (_of_pursuit, _PURSUIT),
    _MPPI_NAME: (_of_mppi, _MPPI),
}


def goal_checkers(
    node: Node, names: Iterable[str], foreign: CppPlugins
) -> dict[str, GoalChecker | CppGoalChecker]:
    """Return the goal checkers by name; StoppedGoalChecker waits for the robot to stop."""
    return {name: _goal_checker(node, name, foreign) for name in names}


def _goal_checker(node: Node, name: str, foreign: CppPlugins) -> GoalChecker | CppGoalChecker:
    kind = declare(node, _GOAL_KIND, name)["plugin"]
    if kind not in _GOAL_KINDS:
        return foreign.get(CppGoalChecker, name, kind, _GOAL_KINDS)
    foreign.log_created(CppGoalChecker, name, kind)
    given = declare(node, _GOAL, name)
    still = declare(node, _STOPPED, name) if kind == _GOAL_KINDS[1] else None
    speeds = (still["trans_stopped_velocity"], still["rot_stopped_velocity"]) if still else None
    return GoalChecker(given["xy_goal_tolerance"], given["yaw_goal_tolerance"], given["stateful"], speeds)


def progress_checker(node: Node, name: str, foreign: CppPlugins) -> ProgressChecker | CppProgressChecker:
    """Return the progress checker; PoseProgressChecker counts rotation as well."""
    kind = declare(node, _PROGRESS_KIND, name)["plugin"]
    if kind not in _PROGRESS_KINDS:
        return foreign.get(CppProgressChecker, name, kind, _PROGRESS_KINDS)
    foreign.log_created(CppProgressChecker, name, kind)
    given = declare(node, _PROGRESS, name)
    turns = declare(node, {"required_movement_angle": 0.5}, name) if kind == _PROGRESS_KINDS[1] else {}
    angle = turns.get("required_movement_angle", math.inf)
    return ProgressChecker(given["required_movement_radius"], given["movement_time_allowance"], angle)
