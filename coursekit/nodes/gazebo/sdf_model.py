"""SDF's `<model>` as a blueprint: links, nested models, includes, poses in named frames."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from coursekit.geometry.plane import Array
from coursekit.urdf import MeshError
from coursekit.urdf.model import Box, Cylinder, Mesh, Sphere
from coursekit.urdf.xml_tree import Element

from .model_colors import PLAIN, look_of
from .model_file import ModelFile, ModelLink
from .model_paths import MissingModel, find_mesh
from .sdf_frames import DEEPEST, frames_of, included, is_merged
from .solids import Outline, Shape, part_of
from .transformed_parts import moved
from .value_parsing import flag, number, numbers, pose, pose_of

QUIET = {
    "pose", "link", "joint", "plugin", "static", "model", "include", "frame", "self_collide", "allow_auto_disable",
    "enable_wind", "placement_frame", "gripper",
}  # fmt: skip


def read_model(element: Element, file: Path | None = None, depth: int = 0) -> ModelFile:
    """Return the blueprint of a `<model>`; its parts are in the model's frame, the model's pose is in its parent's."""
    if depth > DEEPEST:
        raise element.error(f"holds more than {DEEPEST} models inside each other", "Does it include itself?")
    blueprint = ModelFile(element.get("name") or "model", file=file, static=flag(element, "static", False))
    frames = frames_of(element, file, depth)
    blueprint.pose = pose(element) @ np.linalg.inv(frames(element.get("placement_frame") or ""))
    for joint in element.all("joint"):
        blueprint.joints[joint.get("name") or "joint"] = joint.get("type") or ""
        blueprint.static |= joint.tell("parent") == "world" or joint.tell("child") == "world"
    for link in element.all("link"):
        _read_link(link, frames, blueprint)
    for joint in element.all("joint"):
        if joint.tell("child") in blueprint.links:
            blueprint.axles[joint.get("name") or "joint"] = blueprint.links[joint.tell("child")].pose
    blueprint.held = {joint.tell("child") for joint in element.all("joint") if joint.get("type") == "fixed"}
    blueprint.plugins += list(element.all("plugin"))
    for child in element.children:
        if child.tag in ("model", "include"):
            _nest(child, blueprint, file, depth, frames)
        elif child.tag not in QUIET:
            blueprint.note(child, "is not simulated")
    blueprint.root = next(iter(blueprint.links), "")
    blueprint.look = blueprint.look if blueprint.look != PLAIN else look_of(element)
    return blueprint


def include(element: Element, file: Path | None, depth: int = 0) -> ModelFile:
    """Return the blueprint of an `<include>`, renamed and moved accordingly. Raises MeshError if the model is missing."""
    model, path = included(element, file)
    blueprint = read_model(model, path, depth + 1)
    blueprint.name = element.tell("name") or blueprint.name
    if element.first("pose") is not None:
        blueprint.pose = pose(element) @ np.linalg.inv(frames_of(model, path, depth)(element.tell("placement_frame")))
    if element.first("static") is not None:
        blueprint.static = flag(element, "static", blueprint.static)
    blueprint.plugins += element.all("plugin")
    return blueprint


def entity(element: Element, file: Path | None, depth: int, frames: Callable[[str], Array]) -> ModelFile:
    """Return a `<model>` or `<include>` of a world or model, with its pose in that frame. Raises MeshError."""
    inner = include(element, file, depth) if element.tag == "include" else read_model(element, file, depth)
    place = element.first("pose")
    if place is not None:
        inner.pose = frames(place.get("relative_to") or "") @ inner.pose
    return inner


def _nest(element: Element, blueprint: ModelFile, file: Path | None, depth: int, frames: Callable[[str], Array]) -> None:
    try:
        inner = entity(element, file, depth + 1, frames)
    except MissingModel as error:
        blueprint.note(element, f"is left out: {error.what}")
        return
    if is_merged(element):
        _merge(inner, blueprint)
        return
    name, number = inner.name, 0
    while any(key.startswith(f"{name}::") for key in blueprint.links):
        name, number = f"{inner.name}_{number}", number + 1
    for key, link in inner.links.items():
        parts = [moved(part, inner.pose) for part in link.parts]
        blueprint.links[f"{name}::{key}"] = ModelLink(link.name, inner.pose @ link.pose, parts, link.mass, link.sensors)
    blueprint.joints |= {f"{name}::{key}": kind for key, kind in inner.joints.items()}
    blueprint.static |= inner.static
    blueprint.look = blueprint.look if blueprint.look != PLAIN else inner.look
    blueprint.plugins += inner.plugins
    blueprint.notes += inner.notes


def _merge(inner: ModelFile, blueprint: ModelFile) -> None:
    """Merge an `<include merge="true">`: its links and joints become the model's own."""
    for key, link in inner.links.items():
        parts = [moved(part, inner.pose) for part in link.parts]
        blueprint.links[key] = ModelLink(link.name, inner.pose @ link.pose, parts, link.mass, link.sensors)
    blueprint.joints |= inner.joints
    blueprint.held |= inner.held
    blueprint.axles |= {key: inner.pose @ pose for key, pose in inner.axles.items()}
    blueprint.plugins += inner.plugins
    blueprint.notes += inner.notes
    blueprint.look = blueprint.look if blueprint.look != PLAIN else inner.look


def _read_link(link: Element, frames: Callable[[str], Array], blueprint: ModelFile) -> None:
    name = link.get("name") or f"link_{len(blueprint.links)}"
    blue = ModelLink(name, frames(name), mass=number(link, "inertial/mass", 1.0))
    blueprint.links[name] = blue
    for child in link.children:
        if child.tag == "collision":
            place = child.first("pose")
            own = pose_of(place) if place is not None and place.text.strip() else np.eye(4)
            told = place.get("relative_to") if place is not None else None
            _collide(child, (frames(told) if told else blue.pose) @ own, blue, blueprint)
        elif child.tag == "sensor":
            blue.sensors.append(child)


def _collide(element: Element, where: Array, blue: ModelLink, blueprint: ModelFile) -> None:
    geometry = element.first("geometry")
    if geometry is None or not geometry.children:
        raise element.error("has no <geometry>", "Give it <geometry><box>, <cylinder>, <sphere>, <polyline> or <mesh>.")
    kind = geometry.children[0]
    try:
        blue.parts += [part_of(shape, where, blueprint.file) for shape in _shapes(kind, blueprint)]
    except MeshError as error:
        blueprint.note(element, f"is left out: {error.what}")


def _shapes(kind: Element, blueprint: ModelFile) -> list[Shape]:
    if kind.tag == "box":
        x, y, z = _sizes(kind, "size", 3)
        return [Box((x, y, z))]
    if kind.tag == "cylinder":
        return [Cylinder(_sizes(kind, "radius", 1)[0], _sizes(kind, "length", 1)[0])]
    if kind.tag == "sphere":
        return [Sphere(_sizes(kind, "radius", 1)[0])]
    if kind.tag == "polyline":
        return _polyline(kind)
    if kind.tag == "mesh":
        if kind.first("submesh") is not None:
            blueprint.note(kind, "names a submesh: all of the mesh is simulated")
        scale = kind.first("scale")
        x, y, z = numbers(scale, 3) if scale is not None else (1.0, 1.0, 1.0)
        return [Mesh(str(find_mesh(kind.tell("uri"), blueprint.file)), (x, y, z))]
    if kind.tag not in ("plane", "empty"):
        blueprint.note(kind, "is no shape that is simulated; simulated are box, cylinder, sphere, polyline, mesh and plane")
    return []


def _sizes(kind: Element, tag: str, count: int) -> list[float]:
    place = kind.first(tag)
    if place is None:
        raise kind.error(f"has no <{tag}>", f"Add <{tag}>...</{tag}>.")
    sizes = numbers(place, count)
    if min(sizes) <= 0:
        raise place.error(f"is {place.text.strip()}", "Sizes must be more than 0.")
    return sizes


def _polyline(kind: Element) -> list[Shape]:
    points = [numbers(point, 2) for point in kind.all("point")]
    if len(points) > 1 and points[0] == points[-1]:
        points.pop()
    if len(points) < 3:
        raise kind.error(f"is open: it has {len(points)} different points", "Give at least three, round the shape.")
    return [Outline(tuple((x, y) for x, y in points), _sizes(kind, "height", 1)[0])]


__all__ = ["entity", "include", "read_model"]
