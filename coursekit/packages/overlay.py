"""The effect of sourcing a workspace's `install/setup.bash` on an environment, read from colcon's .dsv files."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from pathlib import Path

from coursekit.files import read_text


def overlay_environment(install: Path, env: Mapping[str, str]) -> dict[str, str]:
    """Return `env` as it would be after `source INSTALL/setup.bash`.

    Packages come in the order of their dependencies, so that dependent packages are found first.
    """
    result = dict(env)
    for package, prefix in _packages_in_order(install):
        for action in _actions(prefix, f"share/{package}/package.dsv"):
            _apply(action, prefix, result)
    return result


def _packages_in_order(install: Path) -> list[tuple[str, Path]]:
    packages: dict[str, tuple[Path, list[str]]] = {}
    for prefix in [install, *sorted(entry for entry in install.iterdir() if entry.is_dir())]:
        folder = prefix / "share" / "colcon-core" / "packages"
        for entry in sorted(folder.iterdir()) if folder.is_dir() else ():
            packages[entry.name] = (prefix, [folder for folder in read_text(entry).split(os.pathsep) if folder])
    ordered: dict[str, Path] = {}

    def visit(name: str, path: tuple[str, ...] = ()) -> None:
        if name in packages and name not in ordered and name not in path:
            for needed in packages[name][1]:
                visit(needed, (*path, name))
            ordered[name] = packages[name][0]

    for name in packages:
        visit(name)
    return list(ordered.items())


def _actions(prefix: Path, file: str) -> Iterator[list[str]]:
    path = prefix / file
    if not path.is_file():
        return
    for line in read_text(path).splitlines():
        kind, _, rest = line.strip().partition(";")
        if kind != "source":
            yield [kind, *rest.split(";")]
        elif rest.endswith(".dsv"):
            yield from _actions(prefix, rest)


def _apply(action: list[str], prefix: Path, env: dict[str, str]) -> None:
    kind, name, *values = action
    if kind.startswith("prepend-non-duplicate"):
        for path in (str(prefix / value) for value in values or [""]):
            if not kind.endswith("-if-exists") or Path(path).exists():
                others = [folder for folder in env.get(name, "").split(os.pathsep) if folder and folder != path]
                env[name] = os.pathsep.join([path, *others])
        return
    value = values[0] if values else ""
    if kind == "set":
        env[name] = str(prefix / value) if value and (prefix / value).exists() else value
    elif kind == "set-if-unset":
        env.setdefault(name, value)
