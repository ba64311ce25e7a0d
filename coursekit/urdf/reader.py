"""Reading and checking robot descriptions, as text or as files."""

from __future__ import annotations

import dataclasses
import os
import re
from collections.abc import Mapping
from pathlib import Path

from coursekit.files import is_file, read_text

from .errors import EXPAND, UrdfError, close
from .joints import read_joint
from .links import read_link, read_material
from .model import Joint, Link, Material, Robot
from .tree import check_mimics, find_root
from .xml_tree import Element, read

VERSIONS = ("1.0", "1.1", "1.2")
XACRO_DEFINITIONS = ("xacro:include", "xacro:arg", "xacro:property", "xacro:macro")
"""Names that may remain in an expanded file; any other xacro element means that links are missing."""


def parse(text: str, file: str | os.PathLike[str] = "") -> Robot:
    """Parse a robot's description; `file` is named in errors, and mesh paths are relative to its folder.

    Raises UrdfError with file, line, element and remedy.

    >>> robot = parse('<robot name="ball"><link name="base_link"/></robot>')
    >>> robot.name, robot.root
    ('ball', 'base_link')

    In ROS 2: `urdf::Model::initString`.
    """
    path = os.fspath(file)
    root = read(text, path)
    _check_robot(root)
    materials = _materials(root)
    links: dict[str, Link] = {}
    warnings: list[str] = []
    faults: list[UrdfError] = []
    for element in root.all("link"):
        link = read_link(element, faults)
        if link.name in links:
            cure = f"The first one is in line {links[link.name].line}: give one of them another name."
            raise element.error(f"link '{link.name}' is not unique.", cure)
        links[link.name] = _coloured(link, element, materials, warnings)
    if not links:
        cure = EXPAND if _is_xacro(root) else 'A robot has at least <link name="base_link"/>.'
        raise root.error("No link elements found in urdf file", cure)
    joints = _joints(root, warnings)
    top = find_root(root, links, joints)
    joints = check_mimics(root, joints, warnings)
    gazebo = tuple(root.all("gazebo"))
    name = root.attributes["name"]
    return Robot(name, links, joints, top, materials, gazebo, tuple(warnings), tuple(faults), Path(path) if path else None)


def load(path: str | os.PathLike[str], arguments: Mapping[str, str] | None = None) -> Robot:
    """Load a robot from a .urdf or .xacro file; `arguments` are xacro arguments (`name:=value` on a command line).

    Raises UrdfError, also when there is no such file.
    """
    return parse(load_text(path, arguments), path)


def load_text(path: str | os.PathLike[str], arguments: Mapping[str, str] | None = None) -> str:
    """Return the description in a .urdf or .xacro file as text, not yet checked; raises UrdfError."""
    from .expand import expand

    path = Path(path)
    if not is_file(path):
        beside = sorted(file.name for file in path.parent.glob("*") if file.suffix in (".urdf", ".xacro"))
        cure = close(path.name, beside) if beside else f"Does the folder {path.parent} exist, and is it the right one?"
        raise UrdfError("there is no such file", file=str(path), cure=cure)
    try:
        text = read_text(path)
        return expand(path, arguments) if path.suffix == ".xacro" else text
    except OSError as error:
        raise UrdfError(f"cannot be read: {error.strerror}", file=str(path), cure="A robot description is text.") from None
    except UnicodeDecodeError as error:
        cure = "Is it a mesh or an archive? A robot description is text."
        raise UrdfError(f"is no UTF-8 text: {error}", file=str(path), cure=cure) from None


def _is_xacro(root: Element) -> bool:
    return any(child.tag.startswith("xacro:") for child in root.children)


def _check_robot(root: Element) -> None:
    if root.tag != "robot":
        cure = "The outermost element is <robot>."
        if root.tag == "sdf":
            cure = "This is an SDF file (of Gazebo), not a URDF."
        raise root.error("Could not find the 'robot' element in the xml file", cure)
    if not root.get("name"):
        raise root.error("No name given for the robot.", EXPAND if _is_xacro(root) else 'Write <robot name="my_robot">.')
    version = root.get("version")
    if version is not None and version not in VERSIONS:
        what = "The version attribute should be in the form 'x.y'"
        if re.fullmatch(r"\d+\.\d+", version):
            what = "Invalid 'version' specified; versions from 1.0 upto 1.2 are currently supported"
        raise root.error(what, "Leave version= out.")
    for element in root.children:
        if element.tag.startswith("xacro:") and element.tag not in XACRO_DEFINITIONS:
            what = f"<{element.tag}> is xacro, not URDF"
            raise element.error(what, EXPAND)


def _materials(root: Element) -> dict[str, Material]:
    materials: dict[str, Material] = {}
    for element in root.all("material"):
        material = read_material(element)
        if material.name in materials:
            raise element.error(f"material '{material.name}' is not unique.", "Give one of them another name.")
        materials[material.name] = material
    return materials


def _coloured(link: Link, element: Element, materials: dict[str, Material], warnings: list[str]) -> Link:
    """Return the link with each visual's material resolved, as in urdfdom: the first definition of a name counts."""
    visuals = []
    for visual in link.visuals:
        material = visual.material
        if material is not None and material.name in materials:
            known = materials[material.name]
            if material.colour not in (None, known.colour):
                place = f"{element.file or 'robot description'}:{visual.line}"
                warnings.append(f"{place}: material '{material.name}' has another colour above; that one is used.")
            material = known
        elif material is not None and material.name and (material.colour is not None or material.texture is not None):
            materials[material.name] = material
        elif material is not None and material.name:
            place = f"{element.file or 'robot description'}:{visual.line}"
            hint = close(material.name, materials)
            warnings.append(f"{place}: link '{link.name}' material '{material.name}' undefined. {hint}")
        visuals.append(dataclasses.replace(visual, material=material))
    return dataclasses.replace(link, visuals=tuple(visuals))


def _joints(root: Element, warnings: list[str]) -> dict[str, Joint]:
    joints: dict[str, Joint] = {}
    for element in root.all("joint"):
        joint = read_joint(element)
        if joint.name in joints:
            cure = f"The first one is in line {joints[joint.name].line}: give one of them another name."
            raise element.error(f"joint '{joint.name}' is not unique.", cure)
        if joint.moves and element.first("axis") is None:
            place = f"{element.file or 'robot description'}:{joint.line}"
            warnings.append(f"{place}: joint '{joint.name}' has no <axis>; it moves along or about x.")
        if joint.moves and joint.limit is not None and joint.limit.lower > joint.limit.upper:
            place = f"{element.file or 'robot description'}:{joint.line}"
            warnings.append(f"{place}: joint '{joint.name}' has its lower limit above the upper one: exchange them.")
        joints[joint.name] = joint
    return joints


__all__ = ["load", "load_text", "parse"]
