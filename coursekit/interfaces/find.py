"""The search for definition files: sourced workspaces first, the underlay last."""

from __future__ import annotations

import os
from collections.abc import MutableMapping
from pathlib import Path

from coursekit.files import is_file, read_text
from coursekit.interfaces.errors import UnknownInterface

UNDERLAY = Path(__file__).resolve().parent.parent
KINDS = ("msg", "srv", "action")
_remembered: list[Path] = []


def prefixes() -> list[Path]:
    """Return the ament prefixes in search order: AMENT_PREFIX_PATH, then the underlay."""
    sourced = [Path(p) for p in os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep) if p]
    return list(dict.fromkeys([*sourced, *_remembered, UNDERLAY]))


def with_underlay(environ: MutableMapping[str, str]) -> None:
    """Append the underlay to the prefixes of an environment, as sourcing ROS does.

    >>> environ = {"AMENT_PREFIX_PATH": "/ws/install"}
    >>> with_underlay(environ)
    >>> environ["AMENT_PREFIX_PATH"].split(os.pathsep) == ["/ws/install", str(UNDERLAY)]
    True
    """
    sourced = [folder for folder in environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep) if folder]
    if str(UNDERLAY) not in sourced:
        environ["AMENT_PREFIX_PATH"] = os.pathsep.join([*sourced, str(UNDERLAY)])


def remember(prefix: Path) -> None:
    """Search this prefix too: its Python packages were imported without sourcing its workspace."""
    if prefix not in _remembered:
        _remembered.append(prefix)


def split_name(name: str) -> tuple[str, str, str]:
    """Return package, kind and name; a two-part name means a message.

    >>> split_name('std_msgs/String')
    ('std_msgs', 'msg', 'String')
    """
    parts = name.split("/")
    if len(parts) == 2:
        parts.insert(1, "msg")
    if len(parts) != 3 or not all(parts) or parts[1] not in KINDS:
        raise UnknownInterface(name, known_interfaces())
    return parts[0], parts[1], parts[2]


def find_definition(name: str) -> Path:
    """Return the definition file of 'package/msg/Name' (or 'package/Name').

    Raises UnknownInterface, which lists similar names.

    >>> find_definition("std_msgs/String").name
    'String.msg'
    """
    package, kind, short = split_name(name)
    for prefix in prefixes():
        path = prefix / "share" / package / kind / f"{short}.{kind}"
        if is_file(path):
            return path
    raise UnknownInterface(name, known_interfaces())


def definition_text(name: str) -> str:
    """Return the text of a definition file, including comments and spacing.

    >>> "float64 x" in definition_text("geometry_msgs/msg/Point")
    True
    """
    return read_text(find_definition(name))


def known_packages() -> list[str]:
    """Return the names of all packages with interfaces, sorted."""
    names: set[str] = set()
    for prefix in prefixes():
        for kind in KINDS:
            names.update(path.parent.name for path in (prefix / "share").glob(f"*/{kind}"))
    return sorted(names)


def interfaces_of(package: str, kind: str) -> list[str]:
    """Return the short names of a package's interfaces of one kind, sorted.

    >>> interfaces_of('tf2_msgs', 'srv')
    ['FrameGraph']
    """
    for prefix in prefixes():
        folder = prefix / "share" / package
        if any((folder / k).is_dir() for k in KINDS):
            return sorted(path.stem for path in (folder / kind).glob(f"*.{kind}"))
    return []


def known_interfaces() -> list[str]:
    """Return the full names of all known interfaces, sorted."""
    return [f"{p}/{k}/{n}" for p in known_packages() for k in KINDS for n in interfaces_of(p, k)]
