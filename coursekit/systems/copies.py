"""Copies that stand for links, where an account may make none: whoever looks a package up gets them as new as their sources.

`colcon build --symlink-install` notes them beside what it installs.
"""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import tempfile
from collections.abc import Iterable, Mapping
from pathlib import Path, PurePath
from typing import Any

from coursekit.files import is_file, put_in_place, read_text, write_whole

LISTS = PurePath("share", "ament_index", "resource_index", "coursekit_copies")
"""Below a prefix: a file for each package that has such copies."""


def note(prefix: Path, package: str, copies: Mapping[str, Path], modules: Iterable[Path] = ()) -> None:
    """Write down of a package which installed file is a copy of which source, and which modules are read from the source.

    The files' names are relative to the prefix.
    """
    said = {"files": {name: str(source) for name, source in copies.items()}, "modules": list(map(str, modules))}
    write_whole(prefix / LISTS / package, json.dumps(said, indent=1), parents=True)


def forget(prefix: Path, package: str) -> None:
    """From now on what is installed stays as it is until the next build."""
    (prefix / LISTS / package).unlink(missing_ok=True)


def renew(prefix: Path, package: str) -> None:
    """Copy what was changed since; a source that is gone, or a copy that somebody has open, stays as it is."""
    for copy, source in _files(prefix, package).items():
        with contextlib.suppress(OSError):
            if _is_newer(source, copy):
                _replace(copy, source)


def fresh_sources(prefix: Path, package: str) -> set[Path]:
    """The files, and the folders of modules, that may be changed without a build."""
    modules = _said(prefix, package).get("modules")
    folders = [Path(str(one)) for one in modules] if isinstance(modules, list) else []
    return {one.resolve() for one in [*_files(prefix, package).values(), *folders]}


def _said(prefix: Path, package: str) -> dict[str, Any]:
    try:
        said = json.loads(read_text(prefix / LISTS / package))
    except (OSError, ValueError):
        return {}
    return said if isinstance(said, dict) else {}


def _files(prefix: Path, package: str) -> dict[Path, Path]:
    """Each copy and its source; what lies elsewhere than below the prefix is none of ours."""
    files = _said(prefix, package).get("files")
    if not isinstance(files, dict):
        return {}
    named = {PurePath(name): Path(str(source)) for name, source in files.items()}
    return {prefix / name: source for name, source in named.items() if not (name.is_absolute() or ".." in name.parts)}


def _is_newer(source: Path, copy: Path) -> bool:
    if not is_file(source):
        return False
    new, old = source.stat(), copy.stat()
    return new.st_size != old.st_size or new.st_mtime_ns > old.st_mtime_ns


def _replace(copy: Path, source: Path) -> None:
    """At once, for a launch may be reading it."""
    number, fresh = tempfile.mkstemp(dir=copy.parent, prefix=f".{copy.name[:80]}.")
    os.close(number)
    try:
        shutil.copy2(source, fresh)
        put_in_place(fresh, copy)
    finally:
        with contextlib.suppress(OSError):
            os.unlink(fresh)


__all__ = ["forget", "fresh_sources", "note", "renew"]
