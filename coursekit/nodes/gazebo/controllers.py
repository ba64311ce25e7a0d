"""gazebo_ros2_control and gz_ros2_control: a controller manager in the simulator, with the robot's parameter files."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import yaml

from coursekit.files import read_text
from coursekit.nodes.control.description import HardwareInfo, read_hardware
from coursekit.nodes.control.frames import odometry_frames
from coursekit.nodes.control.types import DRIVE
from coursekit.sim.motors import Reach
from coursekit.sim.robot import Drive
from coursekit.urdf import Limit, MeshError
from coursekit.urdf.resources import find_file
from coursekit.urdf.xml_tree import Element

from .devices import ControlDevice, Device, OdometryDevice
from .model_file import ModelFile
from .ros_names import names_of

if TYPE_CHECKING:
    from collections.abc import Iterable

MANAGER = "controller_manager"
LIMITS = (
    ("linear.x", "velocity", "max_speed"), ("angular.z", "velocity", "max_turn"),
    ("linear.x", "acceleration", "acceleration"), ("angular.z", "acceleration", "turn_acceleration"),
)  # fmt: skip
"""Controller parameters (such as `linear.x.max_velocity`, enabled by `linear.x.has_velocity_limits`), and what they
limit."""


def read_controllers(plugin: Element, model: ModelFile, namespace: str) -> tuple[Drive | None, list[Device]]:
    """Return the drive for the wheel controllers, and the controller manager as a device."""
    try:
        files = [find_file(element.text.strip(), model.file) for element in plugin.all("parameters")]
    except MeshError as error:
        model.note(plugin, f"has no <parameters> that can be read, so nothing controls its joints: {error.what}")
        return None, []
    told = _parameters(plugin, files)
    names = names_of(plugin, namespace)
    space = names.namespace.strip("/")
    prefix = f"/{space}" if space else ""
    robot, hardware = read_hardware(model.text, str(model.file or "")) if model.text else (None, [])
    hardware = [_without_loops(info) for info in hardware]
    if robot is not None:
        model.reach = {name: _reach(joint.limit) for name, joint in robot.joints.items()}
    manager = told.get(MANAGER, {})
    drive: Drive | None = None
    odometry: dict[str, OdometryDevice] = {}
    for name, entry in manager.items():
        if isinstance(entry, dict) and entry.get("type") == DRIVE:
            controller_drive, odometry[name] = _drive(plugin, model, name, told.get(name, {}), prefix)
            drive = drive or controller_drive
    rate = manager.get("update_rate", 100)
    if not isinstance(rate, (int, float)) or not 0 < rate <= 10_000:
        raise plugin.error(f"has an update_rate of {rate}", "Give one above 0, up to 10000 a second.")
    drive = drive or _rolling(hardware, model)
    node = plugin.tell("controller_manager_name") or MANAGER
    words = [f"{old}:={new}" for old, new in names.remappings]
    device = ControlDevice(
        "", "", float(rate), f"{prefix}/{node}", tuple(hardware), tuple(map(str, files)), tuple(words),
        tuple(odometry.items()),
    )  # fmt: skip
    return drive, [device]


def _without_loops(info: HardwareInfo) -> HardwareInfo:
    """Name `position_pid` and `velocity_pid` as GazeboSystem exports them, and as controllers claim them, without `_pid`.

    Joints have no mass here, so the gains of such a loop have nothing to do.
    """
    if info.plugin != "gazebo_ros2_control/GazeboSystem":
        return info
    parts = tuple(
        replace(part, commands=tuple(replace(command, name=command.name.removesuffix("_pid")) for command in part.commands))
        for part in info.components
    )
    return replace(info, components=parts)


def _reach(limit: Limit | None) -> Reach:
    """Return the range and speed limits of a joint; continuous ones have no limits."""
    if limit is None:
        return Reach()
    bounded = limit.lower < limit.upper
    lower, upper = (limit.lower, limit.upper) if bounded else (-math.inf, math.inf)
    return Reach(lower, upper, limit.velocity or math.inf, limit.effort)


def _parameters(plugin: Element, files: list[Path]) -> dict[str, Any]:
    """Read the <parameters> files, node by node; UrdfError for missing or invalid files."""
    parameters: dict[str, Any] = {}
    for file in files:
        try:
            data = yaml.safe_load(read_text(file))
            nodes = {name: dict(node["ros__parameters"]) for name, node in _flat(data).items()}
        except (OSError, ValueError, RecursionError, yaml.YAMLError) as error:
            raise plugin.error(f"<parameters> cannot be read: {error}", "Name the controllers' parameter file.") from None
        except (TypeError, KeyError, AttributeError):
            raise plugin.error("<parameters> is no parameter file", "Write NODE: ros__parameters: ... into it.") from None
        for name, values in nodes.items():
            parameters.setdefault(Path(name).name, {}).update(values)
    return parameters


def _flat(data: dict[str, Any]) -> dict[str, Any]:
    """Return the nodes by name, including those below a namespace."""
    flat = {}
    for name, node in data.items():
        if (
            isinstance(node, dict)
            and "ros__parameters" not in node
            and all(isinstance(setting, dict) for setting in node.values())
        ):
            below = {key: inner for key, inner in node.items() if "ros__parameters" in inner}
            if below:
                flat.update(below)
                continue
        flat[name] = node
    return flat


def _rolling(hardware: Iterable[HardwareInfo], model: ModelFile) -> Drive | None:
    """Return the drive of wheels commanded only by speed; their poses give their separation and radius."""
    wheels = [
        part.name for info in hardware for part in info.components
        if any(command.name == "velocity" for command in part.commands) and model.joints.get(part.name) == "continuous"
        and part.name in model.axles
    ]  # fmt: skip
    sides: tuple[list[str], list[str]] = ([], [])
    for name in wheels:
        sides[float(model.axles[name][1, 3]) < 0].append(name)
    left, right = map(tuple, sides)
    if not left or len(left) != len(right):
        return None
    low = min((part.low for part in model.parts()), default=0.0)
    apart = float(model.axles[left[0]][1, 3] - model.axles[right[0]][1, 3])
    radius = max(float(model.axles[left[0]][2, 3]) - low, 0.01)
    return Drive("differential", acceleration=math.inf, turn_acceleration=math.inf, separation=apart, radius=radius,
                 left=left, right=right)  # fmt: skip


def _drive(plugin: Element, model: ModelFile, name: str, told: dict[str, Any], prefix: str) -> tuple[Drive, OdometryDevice]:
    left, right = (tuple(map(str, told.get(f"{side}_wheel_names", ()))) for side in ("left", "right"))
    if not left or len(left) != len(right):
        raise plugin.error(f"controller '{name}' needs left_wheel_names and right_wheel_names", "Name as many on each side.")
    for joint in left + right:
        if joint not in model.joints:
            raise plugin.error(f"controller '{name}': joint [{joint}] not found", f"Joints are: {', '.join(model.joints)}.")
    try:
        separation, radius = float(told["wheel_separation"]), float(told["wheel_radius"])
        separation *= float(told.get("wheel_separation_multiplier", 1.0))
        limits = _limits(told)
        spreads = tuple(tuple(map(float, told.get(f"{kind}_covariance_diagonal", [0] * 6))) for kind in ("pose", "twist"))
        rate, patience = float(told.get("publish_rate", 50.0)), float(told.get("cmd_vel_timeout", 0.5))
        if min(separation, radius, rate) <= 0 or any(len(spread) not in (0, 6) for spread in spreads):
            raise ValueError
    except (KeyError, TypeError, ValueError):
        cure = "Give wheel_separation and wheel_radius in metres, more than 0, and 6 numbers for each covariance diagonal."
        raise plugin.error(f"controller '{name}' has numbers that are none", cure) from None
    drive = Drive("differential", separation=separation, radius=radius, left=left, right=right, watchdog=patience, **limits)
    stamped, node = bool(told.get("use_stamped_vel", True)), f"{prefix}/{name}"
    odom, base = odometry_frames(told, prefix)
    device = OdometryDevice(
        "~/odom", odom, rate, node, "~/cmd_vel" if stamped else "~/cmd_vel_unstamped", base, True,
        bool(told.get("enable_odom_tf", True)), exact=False, stamped=stamped, spreads=spreads,
    )  # fmt: skip
    return drive, device


def _limits(told: dict[str, Any]) -> dict[str, Any]:
    """Return the limits in the controller's parameters."""
    limits = {}
    for axis, kind, ours in LIMITS:
        value = _nested(told, f"{axis}.max_{kind}")
        if value is not None and _nested(told, f"{axis}.has_{kind}_limits") is True:
            limits[ours] = float(value)
    return limits


def _nested(told: dict[str, Any], path: str) -> Any:
    """Return a parameter written as `a.b.c: 1` or as nested mappings; None if missing."""
    if path in told:
        return told[path]
    value: Any = told
    for part in path.split("."):
        value = value.get(part) if isinstance(value, dict) else None
    return value


__all__ = ["read_controllers"]
