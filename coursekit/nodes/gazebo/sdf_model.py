"""SDF's `<model>` as a blueprint: links, nested models, includes, poses in named frames."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from coursekit.files import read_text
from coursekit.sim.place import Array
from coursekit.urdf import MeshError
from coursekit.urdf.model import Box, Cylinder, Mesh, Sphere
from coursekit.urdf.xml_tree import Element, read

from .blueprint import BlueLink, Blueprint
from .looks import PLAIN, look_of
from .model_paths import MissingModel, find_mesh, find_model
from .moved import moved
from .solids import Outline, Shape, part_of
from .values import flag, number, numbers, pose, pose_of

DEEPEST = 20
"""Models in models; more is a model that includes itself."""
QUIET = {
    "pose", "link", "joint", "plugin", "static", "model", "include", "frame", "self_collide", "allow_auto_disable",
    "enable_wind", "placement_frame", "gripper",
}  # fmt: skip


def read_model(element: Element, file: Path | None = None, depth: int = 0) -> Blueprint:
    """The blueprint of a `<model>`; poses of its parts are in the model's frame, the model's own in its parent's."""
    if depth > DEEPEST:
        raise element.error(f"holds more than {DEEPEST} models inside each other", "Does it include itself?")
    made = Blueprint(element.get("name") or "model", file=file, static=flag(element, "static", False))
    frames = frames_of(element)
    made.pose = pose(element) @ np.linalg.inv(frames(element.get("placement_frame") or ""))
    for joint in element.all("joint"):
        made.joints[joint.get("name") or "joint"] = joint.get("type") or ""
        made.static |= joint.tell("parent") == "world" or joint.tell("child") == "world"
    for link in element.all("link"):
        _read_link(link, frames, made)
    for joint in element.all("joint"):
        if joint.tell("child") in made.links:
            made.axles[joint.get("name") or "joint"] = made.links[joint.tell("child")].pose
    made.plugins += list(element.all("plugin"))
    for child in element.children:
        if child.tag in ("model", "include"):
            _nest(child, made, file, depth, frames)
        elif child.tag not in QUIET:
            made.note(child, "is not simulated")
    made.root = next(iter(made.links), "")
    made.look = made.look if made.look != PLAIN else look_of(element)
    return made


def include(element: Element, file: Path | None, depth: int = 0) -> Blueprint:
    """The blueprint of an `<include>`, renamed and moved as it says. Raises MeshError if the model is not found."""
    path = find_model(element.tell("uri"), file)
    root = read(_text(path), str(path))
    model = root.first("model") if root.tag == "sdf" else None
    if model is None:
        raise root.error("holds no <model>", "Begin with <sdf version='1.7'><model name='...'>.")
    made = read_model(model, path, depth + 1)
    made.name = element.tell("name") or made.name
    if element.first("pose") is not None:
        made.pose = pose(element) @ np.linalg.inv(frames_of(model)(element.tell("placement_frame")))
    if element.first("static") is not None:
        made.static = flag(element, "static", made.static)
    made.plugins += element.all("plugin")
    return made


def _text(path: Path) -> str:
    try:
        return read_text(path)
    except (OSError, UnicodeDecodeError) as error:
        raise MeshError(f"cannot be read: {error}", file=str(path), cure="A model is text in XML.") from None


def entity(element: Element, file: Path | None, depth: int, frames: Callable[[str], Array]) -> Blueprint:
    """A `<model>` or `<include>` inside a world or model, its pose in the frame of that. Raises MeshError."""
    inner = include(element, file, depth) if element.tag == "include" else read_model(element, file, depth)
    place = element.first("pose")
    if place is not None:
        inner.pose = frames(place.get("relative_to") or "") @ inner.pose
    return inner


def _nest(element: Element, made: Blueprint, file: Path | None, depth: int, frames: Callable[[str], Array]) -> None:
    try:
        inner = entity(element, file, depth + 1, frames)
    except MissingModel as error:
        made.note(element, f"is left out: {error.what}")
        return
    name, number = inner.name, 0
    while any(key.startswith(f"{name}::") for key in made.links):
        name, number = f"{inner.name}_{number}", number + 1
    for key, link in inner.links.items():
        parts = [moved(part, inner.pose) for part in link.parts]
        made.links[f"{name}::{key}"] = BlueLink(link.name, inner.pose @ link.pose, parts, link.mass, link.sensors)
    made.joints |= {f"{name}::{key}": kind for key, kind in inner.joints.items()}
    made.static |= inner.static
    made.look = made.look if made.look != PLAIN else inner.look
    made.plugins += inner.plugins
    made.notes += inner.notes


def frames_of(model: Element) -> Callable[[str], Array]:
    """A function from the name of something in a model or world to its pose there."""
    tags = ("link", "joint", "frame", "model", "include")
    named = {one.get("name") or one.tell("name"): one for one in model.children if one.tag in tags}

    def of(name: str, above: tuple[str, ...] = ()) -> Array:
        if name in ("", "__model__", "world"):
            return np.eye(4)
        one = named.get(name)
        if one is None or name in above:
            what = "which is relative to itself" if one is not None else "which does not exist"
            raise model.error(f"has a pose relative to '{name}', {what}", f"Frames are: {', '.join(named) or 'none'}.")
        place = one.first("pose")
        told = place.get("relative_to") if place is not None else None
        usual = one.tell("child") if one.tag == "joint" else (one.get("attached_to") or "" if one.tag == "frame" else "")
        return of(told or usual, (*above, name)) @ pose(one)

    return of


def _read_link(link: Element, frames: Callable[[str], Array], made: Blueprint) -> None:
    name = link.get("name") or f"link_{len(made.links)}"
    blue = BlueLink(name, frames(name), mass=number(link, "inertial/mass", 1.0))
    made.links[name] = blue
    for child in link.children:
        if child.tag == "collision":
            place = child.first("pose")
            own = pose_of(place) if place is not None and place.text.strip() else np.eye(4)
            told = place.get("relative_to") if place is not None else None
            _collide(child, (frames(told) if told else blue.pose) @ own, blue, made)
        elif child.tag == "sensor":
            blue.sensors.append(child)


def _collide(element: Element, where: Array, blue: BlueLink, made: Blueprint) -> None:
    geometry = element.first("geometry")
    if geometry is None or not geometry.children:
        raise element.error("has no <geometry>", "Give it <geometry><box>, <cylinder>, <sphere>, <polyline> or <mesh>.")
    kind = geometry.children[0]
    try:
        shapes = _shapes(kind, made)
        blue.parts += [part_of(shape, where, made.file) for shape in shapes]
    except MeshError as error:
        made.note(element, f"is left out: {error.what}")


def _shapes(kind: Element, made: Blueprint) -> list[Shape]:
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
            made.note(kind, "names a submesh: all of the mesh is simulated")
        scale = kind.first("scale")
        x, y, z = numbers(scale, 3) if scale is not None else (1.0, 1.0, 1.0)
        return [Mesh(str(find_mesh(kind.tell("uri"), made.file)), (x, y, z))]
    if kind.tag not in ("plane", "empty"):
        made.note(kind, "is no shape that is simulated; simulated are box, cylinder, sphere, polyline, mesh and plane")
    return []


def _sizes(kind: Element, tag: str, count: int) -> list[float]:
    place = kind.first(tag)
    if place is None:
        raise kind.error(f"has no <{tag}>", f"Add <{tag}>...</{tag}>.")
    found = numbers(place, count)
    if min(found) <= 0:
        raise place.error(f"is {place.text.strip()}", "Sizes must be more than 0.")
    return found


def _polyline(kind: Element) -> list[Shape]:
    points = [numbers(point, 2) for point in kind.all("point")]
    if len(points) > 1 and points[0] == points[-1]:
        points.pop()
    if len(points) < 3:
        raise kind.error(f"is open: it has {len(points)} different points", "Give at least three, round the shape.")
    return [Outline(tuple((x, y) for x, y in points), _sizes(kind, "height", 1)[0])]


__all__ = ["entity", "frames_of", "include", "read_model"]
