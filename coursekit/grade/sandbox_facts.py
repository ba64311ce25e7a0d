"""Facts from a sandbox as JSON, validated against dataclasses: exact types and known names only."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any, TypeVar

from coursekit.urdf.model import Joint, Link, Mesh, Robot

T = TypeVar("T")
CORNERS = 100_000
"""The maximum number of corners and triangles of all meshes of a robot."""


def checked(kind: type[T], data: bytes | str) -> T:
    """Parse JSON as a type; ValueError when it does not match exactly.

    >>> checked(dict[str, int], '{"a": 1}')
    {'a': 1}
    >>> checked(dict[str, int], '{"a": "1"}')
    Traceback (most recent call last):
    ValueError: Input should be a valid integer
    """
    from pydantic import TypeAdapter, ValidationError

    try:
        return TypeAdapter(kind).validate_json(data, strict=True)
    except ValidationError as error:
        raise ValueError(error.errors(include_url=False)[0]["msg"]) from None


def as_json(value: Any) -> str:
    """Return a dataclass or plain values as JSON for `checked`."""
    return json.dumps(value, default=asdict)


@dataclass
class MeshFacts:
    """The triangles of one mesh file, in its own frame and unscaled [m]."""

    corners: list[list[float]]
    faces: list[list[int]]


@dataclass
class RobotFacts:
    """A robot's description, expanded and parsed; meshes by their names in the description."""

    name: str
    root: str
    links: dict[str, Link]
    joints: dict[str, Joint]
    meshes: dict[str, MeshFacts] = field(default_factory=dict)


@dataclass
class BuildFacts:
    """Whether a package is in install/, and the fault of its build, if any."""

    there: bool
    fault: str = ""
    cure: str = ""


def facts_of(robot: Robot) -> RobotFacts:
    """Convert a robot to facts; MeshError when a mesh cannot be read, ValueError when the meshes are too large."""
    from coursekit.urdf.shapes import mesh_of

    meshes: dict[str, MeshFacts] = {}
    total = 0
    for link in robot.links.values():
        shapes = [*(part.geometry for part in link.visuals), *(part.geometry for part in link.collisions)]
        for shape in shapes:
            if isinstance(shape, Mesh) and shape.filename not in meshes:
                mesh = mesh_of(Mesh(shape.filename), robot.file)
                total += len(mesh.vertices) + len(mesh.faces)
                if total > CORNERS:
                    raise ValueError(f"meshes with more than {CORNERS} corners and triangles together")
                meshes[shape.filename] = MeshFacts(mesh.vertices.tolist(), mesh.faces.tolist())
    return RobotFacts(robot.name, robot.root, robot.links, robot.joints, meshes)


def robot_of(facts: RobotFacts, folder: Path) -> Robot:
    """Make the robot; its meshes are written to `folder` from the validated numbers.

    Raises:
        ValueError: when the facts are not a robot.
    """
    files = {name: _written(mesh, folder / f"{number}.stl") for number, (name, mesh) in enumerate(facts.meshes.items())}
    links = {name: _with_meshes(link, files) for name, link in facts.links.items()}
    if (
        any(joint.parent not in links or joint.child not in links for joint in facts.joints.values())
        or facts.root not in links
    ):
        raise ValueError("joints between links that are not there")
    return Robot(facts.name, links, facts.joints, facts.root)


def _written(mesh: MeshFacts, file: Path) -> str:
    import numpy as np
    import trimesh

    faces, corners = np.array(mesh.faces, int).reshape(-1, 3), np.array(mesh.corners, float).reshape(-1, 3)
    if len(corners) + len(faces) > CORNERS or not np.isfinite(corners).all():
        raise ValueError("a file that is not a mesh")
    if len(faces) and (faces.min() < 0 or faces.max() >= len(corners)):
        raise ValueError("a mesh whose triangles have no corners")
    trimesh.Trimesh(corners, faces, process=False).export(str(file))
    return str(file)


def _with_meshes(link: Link, files: Mapping[str, str]) -> Link:
    def exchanged(part: Any) -> Any:
        shape = part.geometry
        if not isinstance(shape, Mesh):
            return part
        if shape.filename not in files:
            raise ValueError("a mesh that was not sent")
        return replace(part, geometry=Mesh(files[shape.filename], shape.scale))

    visuals, collisions = (tuple(map(exchanged, parts)) for parts in (link.visuals, link.collisions))
    return replace(link, visuals=visuals, collisions=collisions)
