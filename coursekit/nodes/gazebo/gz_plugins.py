"""The newer Gazebo's `<plugin>` elements of models.

They become the same drives and devices as Gazebo Classic's; names and defaults are those of gz-sim.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace

from coursekit.sim.robot import Drive
from coursekit.urdf.xml_tree import Element

from .devices import Device, JointDevice, MotorDevice, OdometryDevice, PoseDevice, TrajectoryDevice
from .model_file import ModelFile
from .value_parsing import flag, number

NODE = "/gz_sim"
"""The node of all devices: the newer Gazebo's topics belong to no node visible in ROS."""
QUIET = (
    "physics", "user-commands", "scene-broadcaster", "sensors", "imu", "contact", "air-pressure", "altimeter", "log",
    "magnetometer", "navsat", "forcetorque", "level", "apply-joint-force", "wheel-slip", "touchplugin",
    "label", "thermal",
)  # fmt: skip
"""Systems that are always present, or need no message."""
_FILE = re.compile(r"(?:lib)?(?:gz-sim|ignition-gazebo)\d*-(.+?)-system(?:\.so)?")


@dataclass(frozen=True)
class GzNames:
    """The default topic names."""

    world: str
    model: str

    def topic(self, told: str, usual: str) -> str:
        """Return the full name of a topic.

        >>> GzNames("w", "cart").topic("cmd_vel", "cmd_vel"), GzNames("w", "cart").topic("", "cmd_vel")
        ('/cmd_vel', '/model/cart/cmd_vel')
        """
        return "/" + (told.strip("/") or f"model/{self.model}/{usual}")

    def sensor(self, link: str, name: str) -> str:
        """Return the default topic of a sensor, without its last part."""
        return f"/world/{self.world}/model/{self.model}/link/{link}/sensor/{name}"


def system_of(plugin: Element) -> str:
    """Return the name of a newer Gazebo's system, '' for other plugins.

    `libignition-gazebo-diff-drive-system.so`, `gz-sim-diff-drive-system` and `gz::sim::systems::DiffDrive` are the
    same.
    """
    match = _FILE.fullmatch((plugin.get("filename") or "").strip())
    if match is not None:
        return match.group(1).lower()
    name = plugin.get("name") or ""
    if not re.match(r"(gz|ignition)::(sim|gazebo)::", name):
        return ""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "-", name.rpartition("::")[2]).lower()


def read_system(system: str, plugin: Element, model: ModelFile) -> tuple[Drive | None, list[Device]]:
    """Return the drive, if it is one, and the devices of a system, with notes on unsupported parts."""
    readers = {
        "diff-drive": _differential,
        "ackermann-steering": _ackermann,
        "mecanum-drive": _planar,
        "velocity-control": _planar,
        "odometry-publisher": _odometry_publisher,
        "joint-state-publisher": _joint_states,
        "joint-position-controller": _position,
        "joint-controller": _velocity,
        "joint-trajectory-controller": _trajectory,
        "pose-publisher": _poses,
    }
    if system in readers:
        return readers[system](plugin, model, GzNames(model.newer or "default", model.name))
    if system not in QUIET:
        known = ", ".join(f"gz-sim-{reader}-system" for reader in readers)
        model.note(plugin, f"of file '{plugin.get('filename')}' is not simulated; simulated are {known}")
    return None, []


def _joints(plugin: Element, model: ModelFile, *tags: str) -> tuple[str, ...]:
    joints = tuple(element.text.strip() for tag in tags for element in plugin.all(tag))
    for name in joints:
        if name not in model.joints:
            known = ", ".join(model.joints) or "none"
            raise plugin.error(f"joint [{name}] not found", f"Joints of {model.name} are: {known}.")
    return joints


def _limit(plugin: Element, *tags: str) -> float:
    return next((number(plugin, tag, math.inf) for tag in tags if plugin.first(tag) is not None), math.inf)


def _differential(plugin: Element, model: ModelFile, names: GzNames) -> tuple[Drive | None, list[Device]]:
    left, right = _joints(plugin, model, "left_joint"), _joints(plugin, model, "right_joint")
    if not left or len(left) != len(right):
        raise plugin.error("needs as many <left_joint> as <right_joint>, at least one", "Name the joints of its wheels.")
    separation, radius = number(plugin, "wheel_separation", 1.0), number(plugin, "wheel_radius", 0.2)
    if separation <= 0 or radius <= 0:
        raise plugin.error(f"has wheels of radius {radius:g} m, {separation:g} m apart", "Both must be more than 0.")
    drive = Drive(
        "differential", _limit(plugin, "max_linear_velocity", "max_velocity"),
        _limit(plugin, "max_angular_velocity", "max_velocity"),
        _limit(plugin, "max_linear_acceleration", "max_acceleration"),
        _limit(plugin, "max_angular_acceleration", "max_acceleration"),
        separation=separation, radius=radius, left=left, right=right,
    )  # fmt: skip
    return drive, [_odometry(plugin, model, names, exact=False)]


def _odometry(plugin: Element, model: ModelFile, names: GzNames, exact: bool) -> OdometryDevice:
    rate = number(plugin, "odom_publish_frequency", 50.0)
    if not 0.0 <= rate <= 10_000.0:
        raise plugin.error(f"has an odom_publish_frequency of {rate:g}", "Give one from 0 to 10000 a second.")
    return OdometryDevice(
        names.topic(plugin.tell("odom_topic"), "odometry"),
        plugin.tell("frame_id") or f"{model.name}/odom",
        rate or 100.0,
        NODE,
        names.topic(plugin.tell("topic"), "cmd_vel"),
        plugin.tell("child_frame_id") or f"{model.name}/{model.root}",
        exact=exact,
        covariance=(0.0, 0.0, 0.0),
        tf_topic=names.topic(plugin.tell("tf_topic"), "tf"),
    )


def _ackermann(plugin: Element, model: ModelFile, names: GzNames) -> tuple[Drive | None, list[Device]]:
    wheels = _joints(plugin, model, "left_joint"), _joints(plugin, model, "right_joint")
    steering = _joints(plugin, model, "left_steering_joint", "right_steering_joint")
    base, separation = number(plugin, "wheel_base", 1.0), number(plugin, "wheel_separation", 1.0)
    if min(base, separation) <= 0:
        raise plugin.error("has a wheel_base or wheel_separation of 0 or less", "Give both in metres.")
    drive = Drive(
        "ackermann", _limit(plugin, "max_velocity"), number(plugin, "steering_limit", 0.5), math.inf, math.inf,
        separation=separation, radius=number(plugin, "wheel_radius", 0.2), left=wheels[0], right=wheels[1], wheelbase=base,
        steering=steering,
    )  # fmt: skip
    return drive, [replace(_odometry(plugin, model, names, exact=True), by_rate=True)]


def _planar(plugin: Element, model: ModelFile, names: GzNames) -> tuple[Drive | None, list[Device]]:
    device = _odometry(plugin, model, names, exact=True)
    return Drive("planar", acceleration=math.inf, turn_acceleration=math.inf), [device]


def _odometry_publisher(plugin: Element, model: ModelFile, names: GzNames) -> tuple[Drive | None, list[Device]]:
    device = OdometryDevice(
        names.topic(plugin.tell("odom_topic"), "odometry"),
        plugin.tell("odom_frame") or f"{model.name}/odom",
        number(plugin, "odom_publish_frequency", 50.0) or 50.0,
        NODE,
        "",
        plugin.tell("robot_base_frame") or f"{model.name}/base_footprint",
        covariance=(0.0, 0.0, 0.0),
        tf_topic=names.topic(plugin.tell("tf_topic"), "pose"),
    )
    return None, [device]


def _joint_states(plugin: Element, model: ModelFile, names: GzNames) -> tuple[Drive | None, list[Device]]:
    joints = _joints(plugin, model, "joint_name") or _turning(model)
    usual = f"/world/{names.world}/model/{names.model}/joint_state"
    topic = "/" + (plugin.tell("topic") or usual).strip("/")
    return None, [JointDevice(topic, "", number(plugin, "update_rate", 100.0) or 100.0, NODE, joints)]


def _poses(plugin: Element, model: ModelFile, names: GzNames) -> tuple[Drive | None, list[Device]]:
    whole = any(flag(plugin, tag, False) for tag in ("publish_model_pose", "publish_nested_model_pose"))
    links = tuple((name, tuple(link.pose.ravel().tolist())) for name, link in model.links.items())
    links = links if flag(plugin, "publish_link_pose", True) else ()
    apart = flag(plugin, "static_publisher", False)
    still = tuple(link for link in links if apart and link[0] in model.held)
    moving = tuple(link for link in links if link not in still)
    topic, world = names.topic(plugin.tell("topic"), "pose"), names.world if whole else ""
    rate, seldom = (number(plugin, key, 60.0) for key in ("update_frequency", "static_update_frequency"))
    devices: list[Device] = [PoseDevice(topic, "", min(rate, 100.0) if rate > 0 else 60.0, NODE, model.name, world, moving)]
    if still:
        rate = min(seldom, 100.0) if seldom > 0 else 60.0
        devices.append(PoseDevice(f"{topic}_static", "", rate, NODE, model.name, "", still))
    return None, devices


def _position(plugin: Element, model: ModelFile, names: GzNames) -> tuple[Drive | None, list[Device]]:
    joints = _joints(plugin, model, "joint_name")
    told = plugin.tell("topic") or plugin.tell("sub_topic")
    return None, [
        MotorDevice(names.topic(told, f"joint/{joint}/{plugin.tell('joint_index') or 0}/cmd_pos"), "", 1.0, NODE, joint)
        for joint in joints
    ]


def _velocity(plugin: Element, model: ModelFile, names: GzNames) -> tuple[Drive | None, list[Device]]:
    told = plugin.tell("topic") or plugin.tell("sub_topic")
    return None, [
        MotorDevice(names.topic(told, f"joint/{joint}/cmd_vel"), "", 1.0, NODE, joint, "velocity")
        for joint in _joints(plugin, model, "joint_name")
    ]


def _turning(model: ModelFile) -> tuple[str, ...]:
    return tuple(joint for joint, kind in model.joints.items() if kind not in ("fixed", ""))


def _trajectory(plugin: Element, model: ModelFile, names: GzNames) -> tuple[Drive | None, list[Device]]:
    joints = _joints(plugin, model, "joint_name") or _turning(model)
    topic, timed = names.topic(plugin.tell("topic"), "joint_trajectory"), flag(plugin, "use_header_start_time", False)
    return None, [TrajectoryDevice(topic, "", 100.0, NODE, joints, timed)]


__all__ = ["NODE", "GzNames", "read_system", "system_of"]
