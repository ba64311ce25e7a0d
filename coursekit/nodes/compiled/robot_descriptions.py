"""A compiled program's requests about robot descriptions: they are parsed here; `cpp/src/urdf.cpp` reads the result."""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING

from coursekit.nodes.compiled.frames import Unpacker, packed
from coursekit.urdf import Box, Collision, Cylinder, Geometry, Joint, Link, Mesh, Origin, Sphere, UrdfError, Visual, parse
from coursekit.urdf.model import Material
from coursekit.urdf.texts import error_text

if TYPE_CHECKING:
    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host

SPHERE, BOX, CYLINDER, MESH = range(4)
"""urdfdom's shape numbers."""
JOINTS = ("unknown", "revolute", "continuous", "prismatic", "floating", "planar", "fixed")
"""urdfdom's joint type numbers."""
_WITHOUT_AXIS = ("floating", "fixed")
_NO_COLOUR = (0.0, 0.0, 0.0, 1.0)


def do_urdf(_host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return urdfdom's messages about a description's faults, then the robot if there is one."""
    try:
        robot = parse(frame.text())
    except UrdfError as error:
        return packed(0, error_text(error))
    parts = [packed(1, "".join(map(error_text, robot.faults)), robot.name, len(robot.materials))]
    parts += [_material(material) for material in robot.materials.values()]
    parts += [packed(len(robot.links)), *map(_link, robot.links.values())]
    parts += [packed(len(robot.joints)), *map(_joint, robot.joints.values())]
    return b"".join(parts)


def _reals(*values: float) -> bytes:
    return struct.pack(f"<{len(values)}d", *values)


def _origin(origin: Origin) -> bytes:
    return _reals(*origin.xyz, *origin.rpy)


def _material(material: Material) -> bytes:
    return packed(material.name, material.texture or "") + _reals(*(material.colour or _NO_COLOUR))


def _geometry(shape: Geometry) -> bytes:
    if isinstance(shape, Sphere):
        return packed(SPHERE) + _reals(shape.radius)
    if isinstance(shape, Box):
        return packed(BOX) + _reals(*shape.size)
    if isinstance(shape, Cylinder):
        return packed(CYLINDER) + _reals(shape.length, shape.radius)
    assert isinstance(shape, Mesh)
    return packed(MESH, shape.filename) + _reals(*shape.scale)


def _visual(visual: Visual) -> bytes:
    material = packed(0) if visual.material is None else packed(1) + _material(visual.material)
    return packed(visual.name) + _origin(visual.origin) + _geometry(visual.geometry) + material


def _collision(collision: Collision) -> bytes:
    return packed(collision.name) + _origin(collision.origin) + _geometry(collision.geometry)


def _link(link: Link) -> bytes:
    parts = [packed(link.name, int(link.inertial is not None))]
    if link.inertial is not None:
        parts += [_origin(link.inertial.origin), _reals(link.inertial.mass, *link.inertial.inertia)]
    parts += [packed(len(link.visuals)), *map(_visual, link.visuals)]
    parts += [packed(len(link.collisions)), *map(_collision, link.collisions)]
    return b"".join(parts)


def _joint(joint: Joint) -> bytes:
    axis = (0.0, 0.0, 0.0) if joint.type in _WITHOUT_AXIS else joint.axis
    parts = [packed(joint.name, JOINTS.index(joint.type), joint.parent, joint.child), _origin(joint.origin), _reals(*axis)]
    parts.append(_reals(joint.damping, joint.friction))
    limit, safety, mimic = joint.limit, joint.safety, joint.mimic
    parts.append(packed(int(limit is not None)))
    if limit is not None:
        parts.append(_reals(limit.lower, limit.upper, limit.effort, limit.velocity))
    parts.append(packed(int(safety is not None)))
    if safety is not None:
        parts.append(_reals(safety.lower, safety.upper, safety.k_position, safety.k_velocity))
    parts.append(packed(int(mimic is not None)))
    if mimic is not None:
        parts += [packed(mimic.joint), _reals(mimic.multiplier, mimic.offset)]
    return b"".join(parts)
