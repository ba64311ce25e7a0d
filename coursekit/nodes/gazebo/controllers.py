"""gazebo_ros2_control: the controllers of a robot's parameter file that drive and tell joints."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import yaml

from coursekit.files import read_text
from coursekit.sim.robot import Drive
from coursekit.urdf import MeshError
from coursekit.urdf.resources import find_file
from coursekit.urdf.xml_tree import Element

from .blueprint import Blueprint
from .devices import Device, JointDevice, OdometryDevice
from .ros_names import names_of

MANAGER = "controller_manager"
DRIVE, JOINTS = "diff_drive_controller/DiffDriveController", "joint_state_broadcaster/JointStateBroadcaster"
LIMITS = (
    ("linear.x.max_velocity", "max_speed"), ("angular.z.max_velocity", "max_turn"),
    ("linear.x.max_acceleration", "acceleration"), ("angular.z.max_acceleration", "turn_acceleration"),
)  # fmt: skip
"""Parameters of the controller, and what they limit."""


def read_controllers(plugin: Element, model: Blueprint, namespace: str) -> tuple[Drive | None, list[Device]]:
    """The drive and the devices of all controllers that the parameters name; a note for what is not simulated."""
    told = _parameters(plugin, model)
    space = names_of(plugin, namespace).namespace.strip("/")
    prefix = f"/{space}" if space else ""
    manager = told.get(MANAGER, {})
    drive: Drive | None = None
    devices: list[Device] = []
    for name, entry in manager.items():
        kind = entry.get("type") if isinstance(entry, dict) else None
        if kind == DRIVE:
            drive, device = _drive(plugin, model, name, told.get(name, {}), prefix)
            devices.append(device)
        elif kind == JOINTS:
            joints = tuple(joint for joint, turns in model.joints.items() if turns not in ("fixed", ""))
            rate = manager.get("update_rate", 100)
            if not isinstance(rate, (int, float)) or not 0 < rate <= 10_000:
                raise plugin.error(f"has an update_rate of {rate}", "Give one above 0, up to 10000 a second.")
            devices.append(JointDevice(f"{prefix}/joint_states", "", rate, f"{prefix}/{name}", joints))
        elif kind is not None:
            model.note(plugin, f"controller '{name}' of type {kind} is not simulated; simulated are {DRIVE} and {JOINTS}")
    return drive, devices


def _parameters(plugin: Element, model: Blueprint) -> dict[str, Any]:
    """What the <parameters> files say, node by node; UrdfError for files that are missing or no such thing."""
    found: dict[str, Any] = {}
    for element in plugin.all("parameters"):
        try:
            data = yaml.safe_load(read_text(find_file(element.text.strip(), model.file)))
            nodes = {name: dict(node["ros__parameters"]) for name, node in data.items()}
        except (MeshError, OSError, ValueError, RecursionError, yaml.YAMLError) as error:
            raise element.error(f"cannot be read: {error}", "Name the controllers' parameter file.") from None
        except (TypeError, KeyError, AttributeError):
            raise element.error("is no parameter file", "Write NODE: ros__parameters: ... into it.") from None
        for name, values in nodes.items():
            found.setdefault(Path(name).name, {}).update(values)
    return found


def _drive(
    plugin: Element, model: Blueprint, name: str, told: dict[str, Any], prefix: str
) -> tuple[Drive, OdometryDevice]:
    left, right = (tuple(map(str, told.get(f"{side}_wheel_names", ()))) for side in ("left", "right"))
    if not left or len(left) != len(right):
        raise plugin.error(f"controller '{name}' needs left_wheel_names and right_wheel_names", "Name as many on each side.")
    for joint in left + right:
        if joint not in model.joints:
            raise plugin.error(f"controller '{name}': joint [{joint}] not found", f"Joints are: {', '.join(model.joints)}.")
    try:
        separation, radius = float(told["wheel_separation"]), float(told["wheel_radius"])
        limits: dict[str, Any] = {
            ours: float(value) for theirs, ours in LIMITS if (value := _nested(told, theirs)) is not None
        }
        rate, patience = float(told.get("publish_rate", 50.0)), float(told.get("cmd_vel_timeout", 0.5))
        if min(separation, radius, rate) <= 0:
            raise ValueError
    except (KeyError, TypeError, ValueError):
        cure = "Give wheel_separation and wheel_radius in metres, more than 0."
        raise plugin.error(f"controller '{name}' has numbers that are none", cure) from None
    made = Drive("differential", separation=separation, radius=radius, left=left, right=right, watchdog=patience, **limits)
    stamped, node = bool(told.get("use_stamped_vel", True)), f"{prefix}/{name}"
    device = OdometryDevice(
        f"{node}/odom", str(told.get("odom_frame_id", "odom")), rate, node,
        f"{node}/cmd_vel" if stamped else f"{node}/cmd_vel_unstamped", str(told.get("base_frame_id", "base_link")),
        True, bool(told.get("enable_odom_tf", True)), exact=False, stamped=stamped,
    )  # fmt: skip
    return made, device


def _nested(told: dict[str, Any], path: str) -> Any:
    """A parameter written as `a.b.c: 1` or as nested mappings; None where it is not."""
    if path in told:
        return told[path]
    value: Any = told
    for part in path.split("."):
        value = value.get(part) if isinstance(value, dict) else None
    return value


__all__ = ["read_controllers"]
