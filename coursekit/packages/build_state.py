"""Whether the installed files of a package match its sources: the last build succeeded, and nothing has changed since."""

from __future__ import annotations

import contextlib
import os
import re
from collections.abc import Collection, Iterator
from pathlib import Path

from coursekit.files import read_bytes, read_text
from coursekit.systems import link_copies

_RULES = ("setup.py", "setup.cfg", "CMakeLists.txt")
"""The files that a build reads; changes of links to them have no effect before the next build."""
_NOT_BUILT = re.compile(r"^\.|^__pycache__$|\.pyc$|\.egg-info$|\.md$|^LICENSE|^CHANGELOG|^tests?$|^build$|^install$|^log$")


def build_fault(workspace: Path, package: str, of: Collection[str] = ()) -> str:
    """Return why `install/` does not match a package's sources; '' if it does, or if that is unknown.

    `of` limits the check to files with these stems; the build files are always checked.
    Files linked by `--symlink-install` may change without a build, as may files that were changed and changed back.

    >>> build_fault(Path("/nowhere"), "py_pubsub")
    ''
    """
    base = workspace / "build" / package
    try:
        result = read_text(base / "colcon_build.rc").strip()
        built_ns = (base / "colcon_build.rc").stat().st_mtime_ns
    except OSError:
        return ""
    if result != "0":
        return f"the last build of {package} failed, so install/ holds an older one"
    source = package_folder(workspace, package)
    matter = [path for path in _sources(source) if _matters(path, of)] if source is not None else []
    newer = [path for path in matter if path.lstat().st_mtime_ns > built_ns]
    if source is None or not newer:
        return ""
    installed = workspace / "install" / package
    prefix = installed if installed.is_dir() else workspace / "install"
    fresh = _linked([base, prefix]) | link_copies.fresh_sources(prefix, package)
    for path in newer:
        if path.name in _RULES or not (_is_below(path, fresh) or _same_bytes(path, installed)):
            return f"{path.relative_to(source).as_posix()} of {package} was changed after the last build"
    return ""


def _matters(path: Path, of: Collection[str]) -> bool:
    return not of or path.name in _RULES or path.name.partition(".")[0] in of


def package_folder(workspace: Path, package: str) -> Path | None:
    """Return the folder of a package's sources below `src/`; None if there is none."""
    for folder, inner, files in os.walk(workspace / "src"):
        if "package.xml" in files:
            inner.clear()  # packages are not nested
            if _name(Path(folder) / "package.xml") == package:
                return Path(folder)
        inner[:] = [name for name in inner if not name.startswith(".")]
    return None


def _name(manifest: Path) -> str:
    match = None
    with contextlib.suppress(OSError):
        match = re.search(r"<name>\s*([^<\s]+)\s*</name>", read_text(manifest, errors="replace"))
    return match[1] if match else manifest.parent.name


def _sources(folder: Path) -> Iterator[Path]:
    for place, inner, files in os.walk(folder):
        inner[:] = [name for name in inner if not _NOT_BUILT.search(name)]
        yield from (Path(place) / file for file in sorted(files) if not _NOT_BUILT.search(file))


def _linked(folders: list[Path]) -> set[Path]:
    """Return the sources that links in these folders point to."""
    sources = set()
    for folder in folders:
        for place, inner, files in os.walk(folder):
            links = (Path(place) / file for file in (*inner, *files))
            sources |= {link.resolve() for link in links if link.is_symlink()}
    return sources


def _is_below(path: Path, linked: set[Path]) -> bool:
    path = path.resolve()
    return path in linked or any(parent in linked for parent in path.parents)


def _same_bytes(path: Path, installed: Path) -> bool:
    try:
        data = read_bytes(path)
        return any(file.is_file() and read_bytes(file) == data for file in installed.rglob(path.name))
    except OSError:
        return False


__all__ = ["build_fault", "package_folder"]
