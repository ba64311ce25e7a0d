"""Model files converted for the simulation: a robot with its devices, or a thing."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace

import numpy as np

from coursekit.geometry.plane import ORIGIN, Array, Pose2D
from coursekit.sim.errors import WorldError
from coursekit.sim.odometry import EXACT
from coursekit.sim.robot import Drive, RobotModel
from coursekit.sim.solids import Disc, Part, Prism
from coursekit.sim.world import Thing
from coursekit.urdf import Robot

from .articulated import Articulated
from .devices import ControlDevice, Device, MotorDevice, OdometryDevice, TrajectoryDevice
from .gz_sensors import devices_of
from .model_file import ModelFile
from .plugins import drift_of, read_plugin
from .sensors import sensed
from .solids import raised
from .transformed_parts import moved
from .value_parsing import yaw_of

LIGHTEST = 0.05
"""The minimum mass of a robot whose file has no masses [kg]."""


@dataclass
class ModelConversion:
    """A model ready for a simulation: a `robot` with `devices`, or `things`."""

    name: str
    robot: RobotModel | None = None
    devices: list[Device] = field(default_factory=list)
    things: list[Thing] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    joints: tuple[str, ...] = ()
    """Rotating joints."""
    frames: dict[str, Array] = field(default_factory=dict)
    """The poses of its links in the model, with joints at 0."""
    place: Pose2D = ORIGIN
    articulated: Articulated | None = None
    """The relation of links and joints, if it has motors."""
    systems: frozenset[str] = frozenset()
    """The systems of the newer Gazebo that it loads."""
    description: Robot | None = None
    """Its description, if it is URDF."""
    lift: float = 0.0
    """The height of its origin above the floor [m]."""


def assemble(made: ModelFile, namespace: str = "") -> ModelConversion:
    """Make a robot if the model has drives or sensors, else a thing. Raises UrdfError and WorldError."""
    place = Pose2D(float(made.pose[0, 3]), float(made.pose[1, 3]), yaw_of(made.pose))
    mast = made.static and any(link.sensors for link in made.links.values())
    if mast:
        _raise(made, _lean(made.pose, place))
    drive, devices = _read_plugins(made, namespace)
    parts = made.parts()
    floor = min((part.low for part in parts), default=0.0) if not mast else 0.0
    for link in made.links.values():
        for sensor in link.sensors:
            newer = made.newer is not None
            devices += devices_of(sensor, link, made, floor) if newer else sensed(sensor, link, made, namespace, floor)
    done = ModelConversion(made.name, None, devices, [], made.notes, place=place)
    done.joints = tuple(name for name, kind in made.joints.items() if kind not in ("fixed", ""))
    if made.robot is not None and any(
        isinstance(device, (ControlDevice, MotorDevice, TrajectoryDevice)) for device in devices
    ):
        done.articulated = Articulated(made.robot, made, 0.0 if made.root == "world" else floor)
    done.systems, done.description = frozenset(made.systems), made.robot
    done.frames = {name: link.pose for name, link in made.links.items()}
    if mast and devices:
        done.robot = RobotModel(made.name, tuple(parts), drive=None, fixed=True)
    elif made.static or not (drive or devices):
        done.things = _things(made, place)
    elif made.root == "world":
        done.robot = RobotModel(made.name, tuple(parts), drive=None, fixed=True, reach=made.reach)
    else:
        done.robot, done.lift = _robot(made, drive, devices, [raised(part, -floor) for part in parts]), -floor
    return done


def _raise(blueprint: ModelFile, level: Array) -> None:
    """Move links and parts to their height above the floor, so that position and heading complete the model's pose."""
    for link in blueprint.links.values():
        link.pose, link.parts = level @ link.pose, [moved(part, level) for part in link.parts]
    blueprint.pose = blueprint.pose @ np.linalg.inv(level)


def _read_plugins(blueprint: ModelFile, namespace: str) -> tuple[Drive | None, list[Device]]:
    drive, devices = None, []
    for plugin in blueprint.plugins:
        plugin_drive, more = read_plugin(plugin, blueprint, namespace)
        if plugin_drive is not None and drive is not None:
            blueprint.note(plugin, "is a second drive; the first one drives")
            continue
        drive = plugin_drive or drive
        devices += more
    return drive, devices


def _robot(blueprint: ModelFile, drive: Drive | None, devices: list[Device], parts: list[Part]) -> RobotModel:
    if not parts:
        blueprint.notes.append(f"{blueprint.name} has no <collision> that can be met: it is simulated as a disc of 0.1 m")
        parts = [Disc(0.0, 0.0, 0.1, 0.0, 0.2)]
    drives = ("drive", "ros2_control")
    source = next(
        (plugin for plugin in blueprint.plugins if any(word in (plugin.get("filename") or "") for word in drives)), None
    )
    told = [*devices, *(device for each in devices if isinstance(each, ControlDevice) for _, device in each.odometry)]
    odometer = next((device for device in told if isinstance(device, OdometryDevice) and device.command_topic), None)
    encoder = odometer is not None and not odometer.exact
    drift = drift_of(source, encoder) if source is not None else EXACT
    return RobotModel(blueprint.name, tuple(parts), max(blueprint.mass(), LIGHTEST), drive, drift, reach=blueprint.reach)


def _things(blueprint: ModelFile, place: Pose2D) -> list[Thing]:
    """Make one thing, with its parts in the model's frame seen from above, at the height in its file."""
    parts = blueprint.parts()
    if not parts:
        return []
    level = _lean(blueprint.pose, place)
    turned = [moved(part, level) for part in parts]
    for part in turned:
        _check(part, blueprint.name)
    mass = None if blueprint.static else max(blueprint.mass(), 1e-3)
    texture, colour = blueprint.look
    return [Thing(blueprint.name, tuple(turned), place, mass, texture=texture, colour=colour, model=blueprint.name)]


def _lean(pose: Array, place: Pose2D) -> Array:
    """Return a pose without its planar position and heading."""
    c, s = math.cos(place.theta), math.sin(place.theta)
    turn = np.array([[c, s, 0, 0], [-s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1.0]])
    flat = pose.copy()
    flat[:2, 3] = 0.0
    rest: Array = turn @ flat
    return rest


def _check(part: Part, name: str) -> None:
    corners = part.corners()
    if not np.isfinite(corners).all() or np.abs(corners).max(initial=0.0) > 1e6:
        raise WorldError("reaches to infinity", element=f"model '{name}'", cure="Check its sizes and poses.")
    if isinstance(part, Prism) and len(part.points) < 2:
        raise WorldError("has an open polygon", element=f"model '{name}'", cure="Give it at least three points.")


def renamed(done: ModelConversion, name: str, place: Pose2D) -> ModelConversion:
    """Return a copy under another name, with its model's pose shifted by `place`."""
    at = Pose2D(place.x + done.place.x, place.y + done.place.y, place.theta + done.place.theta)
    things = [replace(thing, name=name, place=at, model=name) for thing in done.things]
    robot = replace(done.robot, name=name) if done.robot is not None else None
    return replace(done, name=name, place=at, things=things, robot=robot)


__all__ = ["ModelConversion", "assemble", "renamed"]
