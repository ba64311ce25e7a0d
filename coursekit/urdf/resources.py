"""Finding a robot's files: `package://`, `model://`, `file://` and plain paths, all resolved here.

`package://NAME/rest` is searched in this order:

1. folders given to `add_package_path` (the newest first), and those in ROS_PACKAGE_PATH: NAME inside the folder, or the
   folder itself when it is called NAME;
2. `share/NAME` of every prefix in AMENT_PREFIX_PATH, the sourced workspaces;
3. `share/NAME` of coursekit's own underlay;
4. the folders above the robot's file: one that is named NAME, or that contains a folder NAME.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path
from urllib.parse import unquote, urlsplit

from coursekit.files import is_file, is_folder
from coursekit.systems import link_copies, operating_system
from coursekit.systems.command_lines import split_folders
from coursekit.systems.uris import path_of

from .errors import MeshError, close, expanded

MODEL_PATHS = ("GAZEBO_MODEL_PATH", "GAZEBO_RESOURCE_PATH", "GZ_SIM_RESOURCE_PATH", "IGN_GAZEBO_RESOURCE_PATH", "SDF_PATH")
"""Environment variables of Gazebo, old and new, with folders of models."""
UNDERLAY = Path(__file__).resolve().parents[1]
_added: list[Path] = []
_environment: list[Callable[[], Mapping[str, str]]] = []


def take_environment_from(source: Callable[[], Mapping[str, str]]) -> None:
    """Take AMENT_PREFIX_PATH and ROS_PACKAGE_PATH from `source` from now on, instead of the process's environment.

    A notebook's kernel has not sourced the workspace that is built in it.
    """
    _environment[:] = [source]


def add_package_path(folder: str | os.PathLike[str]) -> None:
    """Search this folder first for packages; NotADirectoryError if there is no such folder.

    In ROS 2, build and source a workspace instead, or set ROS_PACKAGE_PATH for older tools.
    """
    path = Path(folder).expanduser().resolve()
    if not path.is_dir():
        raise NotADirectoryError(f"'{path}' is no folder, so no packages can be found there. Check the path.")
    remove_package_path(path)
    _added.insert(0, path)


def remove_package_path(folder: str | os.PathLike[str]) -> None:
    """Remove a folder; harmless when it was not added."""
    path = Path(folder).expanduser().resolve()
    if path in _added:
        _added.remove(path)


def package_paths() -> list[Path]:
    """Return the folders searched for packages, in order; a package is a folder inside one of them."""
    environment = _environment[0]() if _environment else os.environ
    listed = [Path(folder) for folder in environment.get("ROS_PACKAGE_PATH", "").split(os.pathsep) if folder]
    prefixes = [Path(folder) for folder in environment.get("AMENT_PREFIX_PATH", "").split(os.pathsep) if folder]
    shares = [prefix / "share" for prefix in prefixes]
    return list(dict.fromkeys([*_added, *listed, *shares, UNDERLAY / "share"]))


def find_package(name: str, near: Path | None = None) -> Path:
    """Return the folder of a package; `near` is the robot's file. MeshError lists the folders searched.

    >>> find_package("geometry_msgs").name
    'geometry_msgs'
    """
    searched = package_paths()
    for folder in searched:
        if is_folder(folder / name):
            link_copies.renew(folder.parent, name)
            return folder / name
        if folder.name == name and is_folder(folder):
            return folder
    for folder in near.resolve().parents if near is not None else ():
        if folder.name == name:
            return folder
        if is_folder(folder / name):
            return folder / name
    raise MeshError(f"package '{name}' not found", cure=_where(name, searched))


def _where(name: str, searched: list[Path]) -> str:
    there = sorted({path.name for folder in searched if folder.is_dir() for path in folder.iterdir() if path.is_dir()})
    hint = close(name, there)
    lines = [f"  {folder}" for folder in searched]
    first = f"{hint}\n" if hint.startswith("Did") else ""
    return (
        f"{first}Searched were, in this order:\n" + "\n".join(lines) + "\nBuild and source the workspace that has it, "
        "or call add_package_path('the folder that holds the package')."
    )


def model_folders() -> list[Path]:
    """Return the folders in which Gazebo searches for models and their files, from the environment."""
    environment = _environment[0]() if _environment else os.environ
    told = (folder for name in MODEL_PATHS for folder in split_folders(environment.get(name, "")))
    return list(dict.fromkeys(Path(folder).expanduser() for folder in told))


def _in_models(uri: str, near: Path | None) -> Path:
    """Return the file of a `model://NAME/rest`: in Gazebo's folders, else in a package of that name."""
    rest = unquote(uri.removeprefix("model://"))
    for folder in model_folders():
        if is_file(folder / rest):
            return folder / rest
    name, _, inner = rest.partition("/")
    try:
        return find_package(name, near) / inner
    except MeshError:
        cure = f"Is the folder that holds {name or 'its model'} in one of {', '.join(MODEL_PATHS)}?"
        raise MeshError(f"'{uri}' not found", cure=cure) from None


def find_file(uri: str, near: Path | None = None) -> Path:
    """Return the file for a URI or path in a description; `near` is the robot's file.

    Raises MeshError if the package or the file is missing, or the URI has an unknown scheme.

    >>> find_file("package://turtlesim/package.xml").name
    'package.xml'
    """
    try:
        parts = urlsplit(uri)
    except ValueError as error:  # invalid brackets
        raise MeshError(f"'{uri}' is no URI: {error}", cure="Use package://NAME/path, file:///path, or a path.") from None
    if parts.scheme == "package":
        name, _, rest = uri.removeprefix("package://").partition("/")
        if not name:
            cure = "Two slashes, then the package's name: package://NAME/meshes/part.stl."
            raise MeshError(f"'{uri}' names no package", cure=cure)
        path = find_package(name, near) / unquote(rest)
    elif parts.scheme == "model":
        path = _in_models(uri, near)
    elif parts.scheme == "file":
        path = path_of(uri)  # most are not escaped: a '%' or '#' may be part of a name
        computer = parts.netloc if operating_system.WINDOWS else ""
        path = path if path.is_absolute() and is_file(path) else path_of(f"file://{computer}{unquote(parts.path)}")
    elif len(parts.scheme) > 1:
        cure = "Use package://NAME/path, file:///path, or a path relative to the robot's file."
        raise MeshError(f"'{uri}' cannot be read: '{parts.scheme}://' is not known here", cure=cure)
    else:
        path = Path(uri) if near is None else near.resolve().parent / uri
    if not is_file(path) and (is_folder(path) or _is_device(path)):
        raise MeshError(f"'{uri}' is no file: {path} is a folder or a device", cure="Name the mesh file itself.")
    if not is_file(path) and not parts.scheme and near is not None and not is_file(near) and not Path(uri).is_absolute():
        what = f"'{uri}' not found: it is relative to the robot's file, and a description from '{near.as_posix()}' has none"
        raise MeshError(what, cure=expanded(uri, "Use package://NAME/path, or file:///path."))
    if not is_file(path):
        raise MeshError(f"'{uri}' not found: there is no file {path}", cure=expanded(uri, _beside(path)))
    return path


def _is_device(path: Path) -> bool:
    try:
        return path.exists()
    except (OSError, ValueError):
        return False


def _beside(path: Path) -> str:
    folder = path.parent
    if not is_folder(folder):
        return f"There is no folder {folder} either. Is it listed in setup.py's data_files, and was the package built?"
    there = sorted(entry.name for entry in folder.iterdir())
    return f"{close(path.name, there)} Is it listed in setup.py's data_files, and was the package built?"


__all__ = [
    "add_package_path", "find_file", "find_package", "model_folders", "package_paths", "remove_package_path",
    "take_environment_from",
]  # fmt: skip
