"""Make room without losing anything: existing folders are moved beside the workspace."""

from __future__ import annotations

import filecmp
import os
import shutil
from pathlib import Path

from coursekit.words.gettext import gettext

from .errors import NotNow
from .magics import workspace
from .written_parts import WrittenParts


def set_aside(*names: str) -> None:
    """Make room for packages or folders of a chapter: existing ones move to `kept/` in the course folder.

    A name is a path in the workspace or the current folder. A missing name is ignored silently. Content that is
    already kept is not kept twice. RuntimeError when a folder cannot be moved.
    """
    for name in names:
        for path in dict.fromkeys((workspace() / name, Path(name).resolve())):
            if path.exists():
                print(gettext(f"{name} was there already. It is kept: {_keep(path)}"))
                WrittenParts(path).forget()


def _keep(path: Path) -> str:
    folder = Path(os.environ.get("COURSEKIT_COURSE", ".")).resolve() / "kept"
    try:
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "COLCON_IGNORE").touch()  # its packages have the same names as those in the workspace
        number = 1 + max((int(kept.name.rpartition("-")[2]) for kept in _earlier(folder, path.name)), default=0)
        target = folder / f"{path.name}-{number}"
        if number > 1 and _same(path, folder / f"{path.name}-{number - 1}"):
            target = folder / f"{path.name}-{number - 1}"
            shutil.rmtree(path)
        else:
            shutil.move(path, target)
    except OSError as error:
        why = f"'{path}' is in the way and cannot be moved to {folder} ({error.strerror}). Move it yourself."
        raise NotNow(why) from None
    return target.relative_to(folder.parent).as_posix()


def _earlier(folder: Path, name: str) -> list[Path]:
    paths = folder.glob(f"{name}-*")
    return [path for path in paths if path.name.rpartition("-")[0] == name and path.name.rpartition("-")[2].isdecimal()]


def _same(one: Path, other: Path) -> bool:
    """Whether two folders hold the same files with the same bytes, apart from `__pycache__`."""
    if not (one.is_dir() and other.is_dir()):
        return False
    left, right = _names(one), _names(other)
    files = [str(name) for name in left if not (one / name).is_dir()]
    return left == right and not any(filecmp.cmpfiles(one, other, files, shallow=False)[1:])


def _names(folder: Path) -> set[Path]:
    return {path.relative_to(folder) for path in folder.rglob("*") if "__pycache__" not in path.parts}


__all__ = ["set_aside"]
