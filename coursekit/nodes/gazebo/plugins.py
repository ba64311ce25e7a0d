"""`<plugin>` elements of models as drives and devices, with the defaults of gazebo_plugins."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from coursekit.sim.odometry import EXACT, Drift
from coursekit.sim.robot import Drive
from coursekit.urdf.xml_tree import Element

from .controllers import read_controllers
from .devices import Device, JointDevice, OdometryDevice, TruthDevice
from .gz_plugins import read_system, system_of
from .model_file import ModelFile
from .ros_names import names_of
from .value_parsing import flag, number, numbers
from .wheel_frames import wheels_of

Found = tuple[Drive | None, list[Device]]


def read_plugin(plugin: Element, model: ModelFile, namespace: str) -> Found:
    """Return the drive, if it is one, and the devices of a plugin, with notes on unsupported parts."""
    file = (plugin.get("filename") or "").removeprefix("lib").removesuffix(".so").removeprefix("gazebo_ros_")
    readers = {
        "diff_drive": _differential,
        "planar_move": _planar,
        "skid_steer_drive": _skid_steer,
        "joint_state_publisher": _joint_states,
        "p3d": _truth,
        "ackermann_drive": _ackermann,
        "gazebo_ros2_control": read_controllers,
        "gz_ros2_control": read_controllers,
        "ign_ros2_control": read_controllers,
    }
    system = system_of(plugin)
    if system and model.newer is None:
        model.note(plugin, f"of file '{plugin.get('filename')}' is the newer Gazebo's: start its world with ros_gz_sim")
        return None, []
    if system:
        model.systems.add(system)
        return read_system(system, plugin, model)
    reader = readers.get(file.removesuffix("-system"))
    if reader is not None and model.newer is not None and reader is not read_controllers:
        model.note(plugin, f"of file '{plugin.get('filename')}' is Gazebo Classic's: the newer one has gz-sim-...-system")
        return None, []
    if reader is None:
        model.note(plugin, f"of file '{plugin.get('filename')}' is not simulated; simulated are {', '.join(readers)}")
        return None, []
    return reader(plugin, model, namespace)


def _all(plugin: Element, *tags: str) -> tuple[str, ...]:
    return tuple(element.text.strip() for tag in tags for element in plugin.all(tag))


def _check_joints(plugin: Element, model: ModelFile, joints: tuple[str, ...]) -> None:
    for name in joints:
        if name not in model.joints:
            known = ", ".join(model.joints) or "none"
            raise plugin.error(f"joint [{name}] not found", f"Joints of {model.name} are: {known}.")


def _odometry(
    plugin: Element, namespace: str, rate: float, shown: bool, exact: bool
) -> OdometryDevice:
    names = names_of(plugin, namespace)
    x, y, turn = (number(plugin, f"covariance_{axis}", size) for axis, size in (("x", 1e-5), ("y", 1e-5), ("yaw", 1e-3)))
    return OdometryDevice(
        names.topic(plugin.tell("odometry_topic") or plugin.tell("odometryTopic") or "odom"),
        plugin.tell("odometry_frame") or plugin.tell("odometryFrame") or "odom",
        rate,
        names.full_node,
        names.topic(plugin.tell("command_topic") or plugin.tell("commandTopic") or "cmd_vel"),
        plugin.tell("robot_base_frame") or plugin.tell("robotBaseFrame") or "base_footprint",
        flag(plugin, "publish_odom", shown),
        flag(plugin, "publish_odom_tf", shown),
        exact,
        (x, y, turn),
        names.topic("/tf"),
    )


def _rate(plugin: Element, tag: str, default: float) -> float:
    rate = number(plugin, tag, default)
    if not 0.0 <= rate <= 10_000.0:
        raise plugin.error(f"has an {tag} of {rate:g}", "Give one from 0 (as fast as can be) to 10000 a second.")
    return rate or 200.0


def _differential(plugin: Element, model: ModelFile, namespace: str) -> Found:
    left, right = _all(plugin, "left_joint"), _all(plugin, "right_joint")
    if not left or len(left) != len(right):
        raise plugin.error("needs as many <left_joint> as <right_joint>, at least one", "Name the joints of its wheels.")
    _check_joints(plugin, model, left + right)
    push = number(plugin, "max_wheel_acceleration", 0.0)
    separation, diameter = number(plugin, "wheel_separation", 0.34), number(plugin, "wheel_diameter", 0.15)
    return _wheels(plugin, model, namespace, left, right, separation, diameter, push, "odometry_source", "1")


def _skid_steer(plugin: Element, model: ModelFile, namespace: str) -> Found:
    left, right = _all(plugin, "leftFrontJoint", "leftRearJoint"), _all(plugin, "rightFrontJoint", "rightRearJoint")
    _check_joints(plugin, model, left + right)
    separation, diameter = number(plugin, "wheelSeparation", 0.4), number(plugin, "wheelDiameter", 0.15)
    return _wheels(plugin, model, namespace, left, right, separation, diameter, 0.0, "odometrySource", "0")


def _wheels(
    plugin: Element, model: ModelFile, namespace: str, left: tuple[str, ...], right: tuple[str, ...], separation: float,
    diameter: float, push: float, source: str, usual: str,
) -> Found:  # fmt: skip
    if separation <= 0 or diameter <= 0:
        raise plugin.error(f"has wheels {diameter:g} m wide, {separation:g} m apart", "Both must be more than 0.")
    encoder = (plugin.tell(source) or usual).lower() in ("0", "encoder")
    most = push or math.inf
    drive = Drive(
        "differential", acceleration=most, turn_acceleration=most * 2 / separation, separation=separation,
        radius=diameter / 2, left=left, right=right,
    )  # fmt: skip
    rate = _rate(plugin, "update_rate", 100.0)
    return drive, [
        _odometry(plugin, namespace, rate, shown=False, exact=not encoder),
        *_frames(plugin, model, namespace, rate, left + right),
    ]


def _frames(plugin: Element, model: ModelFile, namespace: str, rate: float, joints: tuple[str, ...]) -> list[Device]:
    """Return the frames of the wheels, if the drive publishes them."""
    if not flag(plugin, "publish_wheel_tf", False):
        return []
    if model.robot is None:
        model.note(plugin, "shall publish the wheels' tf: robot_state_publisher does, from /joint_states")
        return []
    names = names_of(plugin, namespace)
    return [wheels_of(model, joints, names.topic("/tf"), rate, names.full_node)]


def _planar(plugin: Element, model: ModelFile, namespace: str) -> Found:
    rate = _rate(plugin, "publish_rate", 20.0)
    drive = Drive("planar", acceleration=math.inf, turn_acceleration=math.inf)
    return drive, [_odometry(plugin, namespace, rate, shown=True, exact=True)]


def _ackermann(plugin: Element, model: ModelFile, namespace: str) -> Found:
    names = [f"{end}_{side}_joint" for end in ("front", "rear") for side in ("left", "right")]
    wheels = tuple(plugin.tell(name) for name in names)
    steering = (*_all(plugin, "left_steering_joint"), *_all(plugin, "right_steering_joint"))
    _check_joints(plugin, model, wheels + steering)
    front, _, rear, other = (model.axles.get(name, np.eye(4))[:3, 3] for name in wheels)
    wheelbase, separation = abs(float(front[0] - rear[0])), abs(float(rear[1] - other[1]))
    if min(wheelbase, separation) <= 0:
        raise plugin.error("has its wheels all in one place", "Put the joints of its wheels where they belong.")
    drive = Drive(
        "ackermann", number(plugin, "max_speed", 20.0), number(plugin, "max_steer", 0.6), math.inf, math.inf,
        separation=separation, radius=max(float(rear[2]), 0.01), left=wheels[0::2], right=wheels[1::2],
        wheelbase=wheelbase, steering=steering,
    )  # fmt: skip
    rate = _rate(plugin, "update_rate", 100.0)
    device = _odometry(plugin, namespace, rate, shown=False, exact=True)
    device = replace(device, base_frame=plugin.tell("robot_base_frame") or "base_link")
    return drive, [device, *_frames(plugin, model, namespace, rate, wheels + steering)]


def _joint_states(plugin: Element, model: ModelFile, namespace: str) -> Found:
    names, joints = names_of(plugin, namespace), _all(plugin, "joint_name")
    for name in joints:
        if name not in model.joints:
            model.note(plugin, f"names joint '{name}', which does not exist")
    rate = _rate(plugin, "update_rate", 100.0)
    return None, [JointDevice(names.topic("joint_states"), "", rate, names.full_node, joints)]


def _truth(plugin: Element, model: ModelFile, namespace: str) -> Found:
    names = names_of(plugin, namespace)
    topic = names.topic(plugin.tell("topic_name") or "odom")
    body = plugin.tell("body_name")
    if body and body not in model.links:
        model.note(plugin, f"names body '{body}', which does not exist; the model itself is taken")
    frame, rate = plugin.tell("frame_name") or "world", _rate(plugin, "update_rate", 100.0)
    return None, [TruthDevice(topic, frame, rate, names.full_node, body)]


def drift_of(plugin: Element, encoder: bool) -> Drift:
    """Read coursekit's own `<drift>` element: six numbers as in `Drift`, or a factor for the default drift."""
    element = plugin.first("drift")
    if element is None:
        return Drift.usual() if encoder else EXACT
    count = len(element.text.split())
    return Drift(*numbers(element, 6)) if count == 6 else Drift.usual(numbers(element, 1)[0])


__all__ = ["drift_of", "read_plugin"]
