"""A robot_description in either format: an SDF model is converted to URDF, for publishing frames and drawing shapes."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from xml.etree.ElementTree import Element as Xml
from xml.etree.ElementTree import SubElement, tostring

import numpy as np

from coursekit.geometry.plane import Array
from coursekit.urdf import Robot, parse
from coursekit.urdf.xml_tree import Element, read

from .sdf_frames import frames_of
from .value_parsing import pose_of

TYPES = {"continuous": "continuous", "revolute": "revolute", "fixed": "fixed", "prismatic": "prismatic"} | dict.fromkeys(
    ("ball", "universal", "gearbox", "revolute2", "screw"), "floating"
)
"""SDF joint types in URDF; joints with several rotation axes become floating: their poses are not published."""
ENDLESS = 1e16


def described(text: str, file: str = "robot_description") -> Robot:
    """Parse a description, URDF or SDF. Raises UrdfError.

    In ROS 2: `urdf::Model` with sdformat_urdf installed.

    >>> described("<sdf version='1.8'><model name='ball'><link name='b'/></model></sdf>").root
    'b'
    """
    root = read(text, file)
    return parse(as_urdf(root) if root.tag == "sdf" else text, file)


def as_urdf(root: Element) -> str:
    """Convert the one model of an `<sdf>` to URDF. Raises UrdfError."""
    model = root.first("model")
    if model is None:
        raise root.error("holds no <model>", "A robot_description is one model: <sdf version='1.8'><model name='...'>.")
    for child in model.children:
        if child.tag in ("model", "include"):
            raise child.error("is a model within a model", "A robot_description is one model; write its links into it.")
    robot = Xml("robot", name=model.get("name") or "model")
    frames = frames_of(model)
    joints = {joint.tell("child"): joint for joint in model.all("joint")}

    def place(link: str) -> Array:
        """Return a link's pose in URDF, which is that of its joint."""
        joint = joints.get(link)
        return frames(link if joint is None else joint.get("name") or "")

    for link in model.all("link"):
        _link(robot, link, place, frames)
    for joint in joints.values():
        _joint(robot, joint, place)
    return tostring(robot, encoding="unicode")


def _link(robot: Xml, link: Element, place: Callable[[str], Array], frames: Callable[[str], Array]) -> None:
    name = link.get("name") or ""
    urdf_link = SubElement(robot, "link", name=name)
    inverse = np.linalg.inv(place(name))

    def beside(part: Element) -> Array:
        """Return the pose of a link's part in the link's URDF frame."""
        told = part.first("pose")
        where = told.get("relative_to") if told is not None else ""
        own = pose_of(told) if told is not None and told.text.strip() else np.eye(4)
        pose: Array = inverse @ frames(where or name) @ own
        return pose

    inertial = link.first("inertial")
    if inertial is not None:
        heavy = SubElement(urdf_link, "inertial")
        _origin(heavy, beside(inertial))
        SubElement(heavy, "mass", value=inertial.tell("mass") or "1")
        words = {key: inertial.tell(f"inertia/{key}") for key in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")}
        usual = {key: str(float(key[1] == key[2])) for key in words}
        SubElement(heavy, "inertia", {key: words[key] or usual[key] for key in words})
    for part in (*link.all("visual"), *link.all("collision")):
        for kind, words in _shapes(part):
            shape = SubElement(urdf_link, part.tag)
            _origin(shape, beside(part))
            SubElement(SubElement(shape, "geometry"), kind, words)
            colour = part.tell("material/diffuse")
            if colour and part.tag == "visual":
                SubElement(SubElement(shape, "material", name=f"{name}_{part.get('name')}"), "color", rgba=colour)


def _shapes(part: Element) -> Iterator[tuple[str, dict[str, str]]]:
    geometry = part.first("geometry")
    for kind in geometry.children if geometry is not None else ():
        if kind.tag == "mesh":
            yield "mesh", {"filename": kind.tell("uri"), "scale": kind.tell("scale") or "1 1 1"}
        elif kind.tag in ("box", "cylinder", "sphere"):
            yield kind.tag, {key: kind.tell(key) for key in ("size", "radius", "length") if kind.tell(key)}


def _joint(robot: Xml, joint: Element, place: Callable[[str], Array]) -> None:
    name, parent, child = joint.get("name") or "", joint.tell("parent"), joint.tell("child")
    kind = TYPES.get(joint.get("type") or "")
    if kind is None:
        raise joint.error(f"has type '{joint.get('type')}'", f"Types are: {', '.join(TYPES)}.")
    lower, upper = (_bound(joint, end, sign) for end, sign in (("lower", -1), ("upper", 1)))
    kind = "continuous" if kind == "revolute" and math.isinf(lower) and math.isinf(upper) else kind
    urdf_joint = SubElement(robot, "joint", name=name, type=kind)
    SubElement(urdf_joint, "parent", link=parent)
    SubElement(urdf_joint, "child", link=child)
    _origin(urdf_joint, np.linalg.inv(place(parent)) @ place(child))
    if kind in ("fixed", "floating"):
        return
    SubElement(urdf_joint, "axis", xyz=joint.tell("axis/xyz") or "0 0 1")
    words = {"lower": repr(max(lower, -ENDLESS)), "upper": repr(min(upper, ENDLESS))}
    most = {key: _bound(joint, key, 1) for key in ("effort", "velocity")}
    words |= {key: "0" if value < 0 or math.isinf(value) else repr(value) for key, value in most.items()}
    SubElement(urdf_joint, "limit", words)


def _bound(joint: Element, end: str, sign: int) -> float:
    """Return a limit of a joint; infinity with that sign if it has none."""
    told = joint.tell(f"axis/limit/{end}")
    try:
        value = float(told) if told else sign * math.inf
    except ValueError:
        value = math.nan
    if math.isnan(value):
        raise joint.error(f"has a limit <{end}> of '{told}'", "Write a number such as 0.5.")
    return sign * math.inf if abs(value) >= ENDLESS else value


def _origin(parent: Xml, pose: Array) -> None:
    roll = math.atan2(pose[2, 1], pose[2, 2])
    pitch = math.atan2(-pose[2, 0], math.hypot(pose[0, 0], pose[1, 0]))
    yaw = math.atan2(pose[1, 0], pose[0, 0])
    xyz = " ".join(repr(float(number)) for number in pose[:3, 3])
    SubElement(parent, "origin", xyz=xyz, rpy=f"{roll!r} {pitch!r} {yaw!r}")


__all__ = ["as_urdf", "described"]
