"""SDF files as worlds: models, includes, saved states; and single models as text."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import unquote

import numpy as np

from coursekit.files import read_text
from coursekit.geometry.plane import Pose2D
from coursekit.sim.errors import WorldError
from coursekit.sim.solids import Part
from coursekit.sim.spherical_coordinates import SphericalCoordinates
from coursekit.sim.world import Thing, World
from coursekit.urdf import parse
from coursekit.urdf.xml_tree import Element, read

from .actors import actor
from .gz_plugins import QUIET as SYSTEMS
from .gz_plugins import system_of
from .model_conversion import ModelConversion, assemble
from .model_file import ModelFile
from .model_paths import MissingModel, is_scenery
from .sdf_frames import frames_of
from .sdf_model import entity, include, read_model
from .settling import settled
from .transformed_parts import moved
from .urdf_model import blueprint_of
from .value_parsing import number, numbers, pose, yaw_of
from .world_plugins import StatePlugin, state_plugin

VERSIONS = ("1.4", "1.5", "1.6", "1.7", "1.8", "1.9", "1.10", "1.11", "1.12")
QUIET = {
    "model", "include", "state", "light", "scene", "gui", "physics", "gravity", "magnetic_field", "atmosphere", "audio",
    "wind", "spherical_coordinates", "frame", "actor",
}  # fmt: skip


@dataclass
class SdfWorld:
    """A world, the models in its file (their things are already in the world), and its plugins."""

    world: World
    models: list[ModelConversion] = field(default_factory=list)
    state: StatePlugin | None = None
    systems: frozenset[str] | None = None
    """The systems of the newer Gazebo that the world loads; None if the file has no list."""


def load_sdf(path: str | Path, newer: bool = False) -> SdfWorld:
    """Load the world of an SDF file as Gazebo Classic or the `newer` one does.

    Raises UrdfError (with line) and WorldError; OSError becomes a WorldError.
    """
    file = Path(path)
    try:
        text = read_text(file)
    except (OSError, UnicodeDecodeError) as error:
        raise WorldError(f"cannot be read: {error}", file=str(file), cure="Check the path of the world.") from None
    root = _root(text, str(file))
    world = root.first("world")
    if world is None:
        raise root.error("holds no <world>", "Begin with <sdf version='1.6'><world name='default'>.")
    return _read_world(world, file, newer)


def _root(text: str, file: str) -> Element:
    root = read(text, file)
    if root.tag not in ("sdf", "gazebo"):
        raise root.error(f"is <{root.tag}>, no SDF", "Begin with <sdf version='1.6'>.")
    if root.get("version") not in VERSIONS:
        raise root.error(f"has version '{root.get('version')}'", f"Versions that can be read: {', '.join(VERSIONS)}.")
    return root


def _read_world(element: Element, file: Path, newer: bool) -> SdfWorld:
    notes: list[str] = []
    blueprints = list(_models(element, file, notes))
    state = element.first("state")
    if state is not None:
        _restore(state, blueprints)
    plugins = [state_plugin(plugin) for plugin in element.all("plugin")]
    for child in element.children:
        told = child.tag == "plugin" and (state_plugin(child) is not None or (newer and system_of(child) in SYSTEMS))
        if child.tag not in QUIET and not told:
            notes.append(f"{file}:{child.line}: {child.label()} is not simulated")
    models, things = [], []
    name = element.get("name") or file.stem
    names: dict[str, int] = {}
    for blueprint in blueprints:
        count = names[blueprint.name] = names.get(blueprint.name, -1) + 1
        if count:
            blueprint.name = f"{blueprint.name}_{count - 1}"
        blueprint.newer = name if newer else None
        done = assemble(blueprint)
        notes += done.notes
        things += done.things
        models.append(done)
    actors = [actor(child) for child in element.all("actor")]
    places = {model.name: model.place for model in (*map(_placed, blueprints), *actors)}
    field = element.first("magnetic_field")
    x, y, z = numbers(field, 3) if field is not None else World("").magnetism
    world = World(
        name, (*settled(things), *actors), file=str(file), notes=tuple(notes), models=places, globe=_globe(element, newer),
        magnetism=(x, y, z),
    )  # fmt: skip
    systems = frozenset(system_of(plugin) for plugin in element.all("plugin"))
    return SdfWorld(world, models, next((plugin for plugin in plugins if plugin is not None), None), systems)


def _globe(world: Element, newer: bool) -> SphericalCoordinates | None:
    told = world.first("spherical_coordinates")
    if told is None:
        return None
    latitude = number(told, "latitude_deg", 0.0)
    if abs(latitude) > 90.0:
        raise told.error(f"has a latitude_deg of {latitude:g}", "Give one from -90 to 90.")
    heading = number(told, "heading_deg", 0.0)
    turned = heading if newer else 180.0 - heading  # Classic's x points west at 0; its worlds give 180
    return SphericalCoordinates(latitude, number(told, "longitude_deg", 0.0), number(told, "elevation", 0.0), turned)


def _placed(blueprint: ModelFile) -> Thing:
    return Thing(
        blueprint.name, (), Pose2D(float(blueprint.pose[0, 3]), float(blueprint.pose[1, 3]), yaw_of(blueprint.pose))
    )


def _models(element: Element, file: Path, notes: list[str]) -> Iterator[ModelFile]:
    frames = frames_of(element, file)
    for child in element.children:
        if child.tag == "include" and is_scenery(child.tell("uri")):
            name = unquote(child.tell("uri")).rpartition("/")[2]
            yield ModelFile(child.tell("name") or name.lower().replace(" ", "_"), static=True)
        elif child.tag in ("model", "include"):
            try:
                yield entity(child, file, 0, frames)
            except MissingModel as error:
                notes.append(f"{file}:{child.line}: {child.label()} is left out: {error.what}")


def _restore(state: Element, blueprints: list[ModelFile]) -> None:
    """Move models to the poses of a saved state, including links moved inside them."""
    saved = {model.get("name"): model for model in state.all("model")}
    for blueprint in blueprints:
        model = saved.get(blueprint.name)
        if model is None or model.first("pose") is None:
            continue
        blueprint.pose = pose(model)
        inverse = np.linalg.inv(blueprint.pose)
        for link in model.all("link"):
            blue = blueprint.links.get(link.get("name") or "")
            if blue is not None and link.first("pose") is not None:
                new = inverse @ pose(link)
                shift = new @ np.linalg.inv(blue.pose)
                blue.parts = [_kept(part, shift) for part in blue.parts]
                blue.pose = new


def _kept(part: Part, shift: np.ndarray) -> Part:
    return part if np.allclose(shift, np.eye(4), atol=1e-5) else moved(part, shift)


def read_entity(
    text: str, namespace: str = "", file: Path | None = None, newer: str | None = None, name: str = ""
) -> ModelConversion:
    """A single model as text, URDF or SDF; `newer` is the name of the newer Gazebo's world, `name` that of the model there.

    Raises UrdfError and WorldError.
    """

    def done(draft: ModelFile) -> ModelConversion:
        draft.newer, draft.name = newer, (name or draft.name) if newer is not None else draft.name
        return assemble(draft, namespace)

    root = read(text, str(file) if file else "")
    if root.tag == "robot":
        blueprint = blueprint_of(parse(text, file or ""))
        blueprint.text = text
        return done(blueprint)
    root = _root(text, str(file) if file else "")
    within = root.first("world") or root
    for child in within.children:
        if child.tag == "model":
            return done(read_model(child, file))
        if child.tag == "include":
            return done(include(child, file))
        if child.tag == "light":
            return ModelConversion(child.get("name") or "light", notes=["a light is not simulated"])
    raise root.error("Failed to find a model or light on SDF", "Put a <model> into it.")


__all__ = ["SdfWorld", "load_sdf", "read_entity"]
