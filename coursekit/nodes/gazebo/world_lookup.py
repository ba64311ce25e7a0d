"""Find the world a user names: a file of coursekit, Gazebo or nav2, or one of the course's worlds by name."""

from __future__ import annotations

from pathlib import Path

import yaml

from coursekit.files import is_file, read_text
from coursekit.nav.map_error import MapError
from coursekit.nav.map_file import load_map
from coursekit.sim import World, WorldError, load_world
from coursekit.sim.errors import known
from coursekit.sim.world_map import world_from_grid

from .model_paths import resource_paths
from .sdf_world import SdfWorld, load_sdf

COURSE = Path(__file__).parents[2] / "share" / "coursekit_maps" / "worlds"


def find_world(name: str) -> Path:
    """Return a world's file: a path, or the name of one of the course's worlds. WorldError lists those."""
    path = Path(name).expanduser()
    if is_file(path):
        return path
    for folder in resource_paths():
        if not path.is_absolute() and is_file(folder / path):
            return folder / path
    ours = COURSE / f"{path.stem}.yaml"
    if str(path.parent) in (".", "worlds") and is_file(ours):
        return ours
    worlds = [file.stem for file in COURSE.glob("*.yaml")]
    cure = f"Give a file, or a name. {known(path.stem, worlds)}"
    raise WorldError(f"there is no world '{name}'", file=str(path), cure=cure)


def open_world(name: str, newer: bool = False) -> SdfWorld:
    """Load a world and its models, as Gazebo Classic or the `newer` Gazebo reads them; '' is an empty world.

    Raises WorldError and UrdfError.
    """
    if not name or (newer and name == "empty.sdf" and not is_file(name)):
        return SdfWorld(World("empty" if name else "default"), systems=frozenset() if newer else None)
    path = find_world(name)
    if path.suffix in (".yaml", ".yml"):
        return SdfWorld(_of_map(path) if _is_map(path) else load_world(path))
    return load_sdf(path, newer)


def _is_map(path: Path) -> bool:
    try:
        data = yaml.safe_load(read_text(path))
    except (OSError, ValueError, RecursionError, yaml.YAMLError):
        return False
    return isinstance(data, dict) and "image" in data


def _of_map(path: Path) -> World:
    try:
        grid = load_map(path)
    except MapError as error:
        raise WorldError(str(error), file=str(path), cure="Mend the map, or give another world.") from None
    x, y, yaw = grid.origin
    return world_from_grid(grid.cells, grid.resolution, (x, y, yaw), path.stem, str(path))


__all__ = ["find_world", "open_world"]
