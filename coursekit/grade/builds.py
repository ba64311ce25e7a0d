"""Whether a package's build is that of its source: what a check says when it is not."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

_READ_BY_THE_BUILD = ("setup.py", "setup.cfg", "package.xml", "CMakeLists.txt", ".msg", ".srv", ".action")
"""Files, and kinds of files, that matter only when a package is built, also with --symlink-install."""
_MADE = ("__pycache__", ".egg-info", ".pytest_cache", ".ipynb_checkpoints")


def build_note(workspace: Path, packages: Iterable[str]) -> str:
    """What is to be known of the builds of these packages; empty when each is that of its source.

    A package that was built with `--symlink-install` uses its Python files as they are: those may be newer.
    """
    return " ".join(note for one in dict.fromkeys(packages) if (note := _note(workspace, one)))


def _note(workspace: Path, package: str) -> str:
    source, done = workspace / "src" / package, workspace / "build" / package / "colcon_build.rc"
    again = f"%colcon build --packages-select {package}"
    try:
        built, code = done.stat().st_mtime, done.read_text(encoding="utf-8").strip()
        newer = [file.name for file in _sources(workspace, source) if file.stat().st_mtime > built]
    except (OSError, ValueError):
        return ""
    if code != "0":
        return f"The last build of {package} failed: what runs is older. Look at what this prints: {again}"
    if newer:
        return f"{newer[0]} was changed after the last build of {package}, which is what runs. Run: {again}"
    return ""


def _sources(workspace: Path, source: Path) -> Iterator[Path]:
    """The files whose changes need a build."""
    linked = any((workspace / "install" / source.name).glob("lib/python*/site-packages/*.egg-link"))
    for file in sorted(source.rglob("*")):
        if not file.is_file() or any(part.endswith(_MADE) for part in file.relative_to(source).parts):
            continue
        if not linked or file.name.endswith(_READ_BY_THE_BUILD):
            yield file
