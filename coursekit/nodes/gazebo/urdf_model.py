"""Convert URDF with `<gazebo>` blocks to a blueprint."""

from __future__ import annotations

from collections.abc import Iterator

from coursekit.urdf import MeshError, Robot
from coursekit.urdf.errors import close
from coursekit.urdf.kinematics import Kinematics
from coursekit.urdf.shapes import matrix_of
from coursekit.urdf.xml_tree import Element

from .gz_sensors import lumped
from .model_colors import PLAIN, look_named
from .model_file import ModelFile, ModelLink
from .solids import part_of
from .value_parsing import flag, matrix

QUIET = {
    "material", "mu1", "mu2", "kp", "kd", "minDepth", "maxVel", "fdir1", "selfCollide", "turnGravityOff", "gravity",
    "dampingFactor", "maxContacts", "laserRetro", "visual", "self_collide", "max_contacts", "min_depth", "max_vel",
    "disableFixedJointLumping", "preserveFixedJoint", "implicitSpringDamper", "provideFeedback", "stopCfm", "stopErp",
    "springStiffness", "springReference", "kinematic", "collision", "inertial", "velocity_decay", "enable_wind",
}  # fmt: skip
"""Child elements for Gazebo's physics engine and rendering; a 2D world needs none of them."""


def blueprint_of(robot: Robot) -> ModelFile:
    """Return a robot's blueprint. Raises UrdfError for invalid numbers; a missing mesh becomes a note."""
    blueprint = ModelFile(robot.name, file=robot.file, root=robot.root, robot=robot)
    blueprint.joints = {name: joint.type for name, joint in robot.joints.items()}
    for name, pose in Kinematics(robot).poses().items():
        link = robot.links[name]
        blueprint.links[name] = blue = ModelLink(name, matrix(pose), mass=link.inertial.mass if link.inertial else 0.0)
        for collision in link.collisions:
            try:
                where = blue.pose @ matrix_of(collision.origin)
                blue.parts.append(part_of(collision.geometry, where, robot.file))
            except MeshError as error:
                blueprint.notes.append(f"line {collision.line}: <collision> of link '{name}' is left out: {error.what}")
    blueprint.axles = {name: blueprint.links[joint.child].pose for name, joint in robot.joints.items()}
    blueprint.held = {joint.child for joint in robot.joints.values() if joint.type == "fixed"}
    parents = {joint.child: (name, joint.type, joint.parent) for name, joint in robot.joints.items()}
    blueprint.lumped = lumped(parents, frozenset(_kept(robot)))
    for block in robot.gazebo:
        _read_block(block, robot, blueprint)
    return blueprint


def _kept(robot: Robot) -> Iterator[str]:
    """Yield the fixed joints that are marked to be preserved."""
    for block in robot.gazebo:
        if any(flag(block, tag, False) for tag in ("preserveFixedJoint", "disableFixedJointLumping")):
            yield block.get("reference") or ""


def _read_block(block: Element, robot: Robot, blueprint: ModelFile) -> None:
    reference = block.get("reference")
    for child in block.children:
        if child.tag == "plugin":
            blueprint.plugins.append(child)
        elif child.tag == "sensor" and reference in blueprint.links:
            blueprint.links[reference].sensors.append(child)
        elif child.tag == "sensor":
            missing = f"is left out: there is no link '{reference}'. {close(reference or '', blueprint.links)}"
            blueprint.note(child, "is not simulated: it sits on a joint" if reference in robot.joints else missing)
        elif child.tag == "static":
            blueprint.static = child.text.strip() in ("true", "1")
        elif child.tag == "material" and blueprint.look == PLAIN:
            blueprint.look = look_named(child.text.strip())
        elif child.tag not in QUIET:
            blueprint.note(child, "is not simulated")
    if reference and reference not in robot.links and reference not in robot.joints:
        blueprint.note(block, f"refers to '{reference}', which does not exist")


__all__ = ["blueprint_of"]
