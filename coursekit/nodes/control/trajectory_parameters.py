"""The parameters of joint_trajectory_controller."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .controller import ControlError, Controller
from .pid import Gains
from .tolerances import Tolerances

KINDS = ("position", "velocity", "acceleration", "effort")
"""The interfaces of a joint for commands and states."""


@dataclass(frozen=True)
class TrajectoryParameters:
    """The validated parameters of one controller."""

    joints: tuple[str, ...]
    command_joints: tuple[str, ...]
    commands: tuple[str, ...]
    states: tuple[str, ...]
    tolerances: Tolerances
    gains: tuple[Gains, ...]
    feedforward: tuple[float, ...]
    """The share of the desired velocity that each joint's loop adds."""
    partial: bool = False
    moving_end: bool = True
    open_loop: bool = False
    splines: bool = True
    period_ns: int = 0
    """The period of its state messages."""

    @classmethod
    def of(cls, controller: Controller) -> TrajectoryParameters:
        """Read the parameters of a controller's node. Raises ControlError."""
        told = controller.parameter
        joints = tuple(told("joints", []))
        names = tuple(told("command_joints", [])) or joints
        commands, states = tuple(told("command_interfaces", [])), tuple(told("state_interfaces", []))
        _check(joints, names, commands, states)
        told("action_monitor_rate", 20.0)
        rate = float(told("state_publish_rate", 50.0))
        gains = tuple(_gains(controller, joint) for joint in joints)
        feedforward = tuple(float(told(f"gains.{joint}.ff_velocity_scale", 0.0)) for joint in joints)
        return cls(
            joints, names, commands, states, _tolerances(controller, joints), gains, feedforward,
            bool(told("allow_partial_joints_goal", False)),
            bool(told("allow_nonzero_velocity_at_trajectory_end", True)), bool(told("open_loop_control", False)),
            told("interpolation_method", "splines") != "none", round(1e9 / rate) if rate > 0 else 0,
        )  # fmt: skip


def _check(joints: tuple[str, ...], names: tuple[str, ...], commands: tuple[str, ...], states: tuple[str, ...]) -> None:
    if not joints:
        raise ControlError("'joints' parameter is empty.")
    if len(names) != len(joints):
        raise ControlError("'command_joints' parameter has to have the same size as 'joints' parameter.")
    if not commands:
        raise ControlError("'command_interfaces' parameter is empty: it is for example [position]")
    if "position" not in states:
        raise ControlError("'state_interfaces' must have at least 'position'")
    wrong = [kind for kind in (*commands, *states) if kind not in KINDS]
    if wrong:
        raise ControlError(f"interface '{wrong[0]}' is not known; there are {', '.join(KINDS)}")
    if commands == ("velocity",) and "velocity" not in states:
        raise ControlError("'velocity' command interface alone needs a 'velocity' state interface")


def _gains(controller: Controller, joint: str) -> Gains:
    p, i, d, clamp = (float(controller.parameter(f"gains.{joint}.{gain}", 0.0)) for gain in ("p", "i", "d", "i_clamp"))
    return Gains(p, i, d, i_max=clamp, i_min=-clamp)


def _tolerances(controller: Controller, joints: tuple[str, ...]) -> Tolerances:
    told = controller.parameter
    stopped = float(told("constraints.stopped_velocity_tolerance", 0.01))
    path, goal = (
        np.array([float(told(f"constraints.{joint}.{kind}", 0.0)) for joint in joints]) for kind in ("trajectory", "goal")
    )
    time = float(told("constraints.goal_time", 0.0))
    return Tolerances(path, goal, np.full(len(joints), stopped), goal_time=time)


__all__ = ["KINDS", "TrajectoryParameters"]
