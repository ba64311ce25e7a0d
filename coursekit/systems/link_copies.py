"""Copies instead of links, for accounts that may not create links: looking up a package updates its copies.

`colcon build --symlink-install` records them beside the installed files.
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
"""Folder below a prefix, with a file for each package that has such copies."""


def note(prefix: Path, package: str, copies: Mapping[str, Path], modules: Iterable[Path] = ()) -> None:
    """Record a package's copies with their sources, and the modules that are read from the source.

    The names of the copies are relative to the prefix.
    """
    said = {"files": {name: str(source) for name, source in copies.items()}, "modules": list(map(str, modules))}
    write_whole(prefix / LISTS / package, json.dumps(said, indent=1), parents=True)


def forget(prefix: Path, package: str) -> None:
    """Stop updating a package: its installed files stay unchanged until the next build."""
    (prefix / LISTS / package).unlink(missing_ok=True)


def renew(prefix: Path, package: str) -> None:
    """Copy changed sources; a missing source, or a copy that another program has open, is skipped."""
    for copy, source in _files(prefix, package).items():
        with contextlib.suppress(OSError):
            if _is_newer(source, copy):
                _replace(copy, source)


def fresh_sources(prefix: Path, package: str) -> set[Path]:
    """Return the files, and the folders of modules, that may be changed without a build."""
    modules = _said(prefix, package).get("modules")
    folders = [Path(str(module)) for module in modules] if isinstance(modules, list) else []
    return {path.resolve() for path in [*_files(prefix, package).values(), *folders]}


def _said(prefix: Path, package: str) -> dict[str, Any]:
    try:
        said = json.loads(read_text(prefix / LISTS / package))
    except (OSError, ValueError):
        return {}
    return said if isinstance(said, dict) else {}


def _files(prefix: Path, package: str) -> dict[Path, Path]:
    """Return each copy with its source; files outside of the prefix are ignored."""
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
    """Replace atomically, because a launch may be reading the file."""
    number, fresh = tempfile.mkstemp(dir=copy.parent, prefix=f".{copy.name[:80]}.")
    os.close(number)
    try:
        shutil.copy2(source, fresh)
        put_in_place(fresh, copy)
    finally:
        with contextlib.suppress(OSError):
            os.unlink(fresh)


__all__ = ["forget", "fresh_sources", "note", "renew"]
