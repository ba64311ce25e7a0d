"""`model://NAME`: the search paths of Gazebo models."""

from __future__ import annotations

import os
from functools import lru_cache
from pathlib import Path
from urllib.parse import unquote

from coursekit.files import is_file, is_folder, read_text
from coursekit.systems.command_lines import split_folders
from coursekit.urdf import MeshError, UrdfError
from coursekit.urdf.errors import close
from coursekit.urdf.resources import find_file, package_paths
from coursekit.urdf.xml_tree import read

PATH, RESOURCES = "GAZEBO_MODEL_PATH", "GAZEBO_RESOURCE_PATH"
NEWER = ("GZ_SIM_RESOURCE_PATH", "IGN_GAZEBO_RESOURCE_PATH", "SDF_PATH")
"""The newer Gazebo's variables, for models and resources alike."""
SCENERY = ("sun", "ground_plane")
"""Models that are part of every flat, lit world."""


def is_scenery(uri: str) -> bool:
    """Whether a model is part of SCENERY, from a folder or from the web.

    >>> is_scenery("model://sun"), is_scenery("https://fuel.gazebosim.org/1.0/OpenRobotics/models/Ground Plane")
    (True, True)
    """
    return unquote(uri).rstrip("/").rpartition("/")[2].lower().replace(" ", "_") in SCENERY


class MissingModel(MeshError):
    """A model is in no folder; the world continues without it, as in Gazebo."""


def model_paths(near: Path | None = None) -> list[Path]:
    """Return the folders: GAZEBO_MODEL_PATH, `models` beside and above the file, package exports, resources."""
    above = list(near.resolve().parents)[:4] if near is not None else []
    beside = [*above[1:3], *(folder / "models" for folder in above)]
    return [*told_by(PATH), *told_by(*NEWER), *beside, *exported("gazebo_model_path"), *resource_paths()]


def resource_paths() -> list[Path]:
    """Return GAZEBO_RESOURCE_PATH and package exports: the search path of worlds and relative `file://` URIs."""
    return [*told_by(RESOURCES, *NEWER), *exported("gazebo_media_path")]


def told_by(*variables: str) -> list[Path]:
    """Return the folders in environment variables."""
    return [Path(folder).expanduser() for name in variables for folder in split_folders(os.environ.get(name, ""))]


def exported(attribute: str) -> list[Path]:
    """Return folders exported by packages: `<gazebo_ros gazebo_model_path="${prefix}/models"/>` in package.xml."""
    shares = [share for share in package_paths() if share.is_dir()]
    return list(_exported(attribute, tuple((share, share.stat().st_mtime_ns) for share in shares)))


@lru_cache(maxsize=8)
def _exported(attribute: str, shares: tuple[tuple[Path, int], ...]) -> tuple[Path, ...]:
    """Cached until a package is added to or removed from a folder: a world calls this for each of its meshes."""
    folders: list[Path] = []
    for file in (path for share, _ in shares for path in sorted(share.glob("*/package.xml"))):
        try:
            text = read_text(file, errors="replace")
        except OSError:
            continue
        try:
            export = read(text, str(file)).first("export") if "<gazebo_ros" in text else None
        except UrdfError:  # colcon reports its fault
            continue
        for element in export.all("gazebo_ros") if export is not None else ():
            told = (element.get(attribute) or "").replace("${prefix}", str(file.parent))
            folders += [Path(folder) for folder in split_folders(told)]
    return tuple(folders)


def find_model(uri: str, near: Path | None = None) -> Path:
    """Return the SDF file of a `model://NAME` or `package://NAME` (or a folder or file); MeshError lists the searched
    folders.
    """
    of_package = uri.startswith("package://")
    name = unquote(uri.removeprefix("model://").removeprefix("package://").removeprefix("file://"))
    folders = [*model_paths(near), *(package_paths() if of_package else ())]
    for place in [folder / name for folder in folders] if not Path(name).is_absolute() else [Path(name)]:
        if is_file(place):
            return place
        if is_folder(place):
            return _sdf_in(place)
    if uri.startswith(("http://", "https://")):
        what = f"model '{uri}' is on the web, and nothing is fetched from there"
        cure = f"Download it, and name its folder: <uri>model://{name.rpartition('/')[2]}</uri>."
        raise MissingModel(what, file=str(near or "SDF"), cure=cure)
    there = sorted({path.parent.name for folder in folders if folder.is_dir() for path in folder.glob("*/model.config")})
    searched = "\n".join(f"  {folder}" for folder in folders) or "  (none)"
    raise MissingModel(
        f"model '{uri}' not found; is its folder in {PATH}?", file=str(near or "SDF"),
        cure=f"{close(name, there)} Searched were:\n{searched}\nAdd its folder: export {PATH}=/folder/of/models:${PATH}",
    )  # fmt: skip


def _sdf_in(folder: Path) -> Path:
    config = folder / "model.config"
    if config.is_file():
        rows = [element.text.strip() for element in read(_text_of(config), str(config)).all("sdf")]
        for name in reversed(rows):
            if is_file(folder / name):
                return folder / name
    if (folder / "model.sdf").is_file():
        return folder / "model.sdf"
    raise MeshError("has no model.sdf", file=str(folder), cure="Name its file in model.config: <sdf>model.sdf</sdf>.")


def _text_of(config: Path) -> str:
    try:
        return read_text(config)
    except (OSError, UnicodeDecodeError) as error:
        raise MeshError(f"cannot be read: {error}", file=str(config), cure="It is text in XML.") from None


def find_mesh(uri: str, near: Path | None = None) -> Path:
    """Return the file of a mesh URI: model://, package://, file:// or a path. Raises MeshError."""
    rest = unquote(uri.removeprefix("model://").removeprefix("file://"))
    if rest == uri or rest.startswith("/"):
        return find_file(uri, near)
    for folder in model_paths(near):
        if is_file(folder / rest):
            return folder / rest
    try:
        return find_file("package://" + rest, near)
    except MeshError:
        raise MeshError(f"'{uri}' not found", file=str(near or "SDF"), cure=f"Is its model's folder in {PATH}?") from None


__all__ = ["MissingModel", "find_mesh", "find_model", "is_scenery", "resource_paths"]
