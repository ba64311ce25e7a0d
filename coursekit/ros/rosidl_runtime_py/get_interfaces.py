"""The existing interfaces, by package."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

from ament_index_python import get_resource, get_resources, has_resource

from coursekit.interfaces.idl import idl_file

_SUFFIXES = {"msg": (".msg", ".idl"), "srv": (".srv", ".idl"), "action": (".action", ".idl")}


def get_interface_packages() -> dict[str, str]:
    """Return the packages that have interfaces, with their prefixes."""
    packages: dict[str, str] = get_resources("rosidl_interfaces")
    return packages


def _of(package_names: Iterable[str], kinds: Iterable[str]) -> dict[str, list[str]]:
    names_by_package = {
        package: _names(package, kinds) for package in list(package_names) or sorted(get_interface_packages())
    }
    return {package: names for package, names in names_by_package.items() if names}


def _names(package: str, kinds: Iterable[str]) -> list[str]:
    if not has_resource("packages", package):
        raise LookupError(f"Unknown package '{package}'")
    if not has_resource("rosidl_interfaces", package):
        return []
    lines = get_resource("rosidl_interfaces", package)[0].splitlines()
    suffixes = tuple(f"{kind}/" for kind in kinds)
    stems = (os.path.splitext(line) for line in lines if line.startswith(suffixes))
    return sorted({stem for stem, end in stems if end in _SUFFIXES[stem.split("/")[0]] and "_" not in stem})


def get_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return all interfaces by package, such as {'std_srvs': ['srv/Empty', ...]}; raises LookupError."""
    return _of(package_names, ("msg", "srv", "action"))


def get_message_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the messages by package.

    >>> get_message_interfaces(['builtin_interfaces'])
    {'builtin_interfaces': ['msg/Duration', 'msg/Time']}
    """
    return _of(package_names, ("msg",))


def get_service_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the services by package."""
    return _of(package_names, ("srv",))


def get_action_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the actions by package."""
    return _of(package_names, ("action",))


def _as_idl(package: str, path: Path) -> Path | None:
    """The IDL of a definition. ROS installs it beside the definition; here it is written on demand."""
    definitions = [path.with_suffix(suffix) for suffix in (".msg", ".srv", ".action")]
    definition = next((definition for definition in definitions if definition.exists()), None)
    return idl_file(package, definition) if path.suffix == ".idl" and definition is not None else None


def get_interface_path(interface_name: str) -> str:
    """Return the path of a definition file.

    Raises ValueError for a malformed name and LookupError if the interface does not exist.
    """
    parts = interface_name.split("/")
    if len(parts) < 2:
        raise ValueError(f"Invalid name '{interface_name}'. Expected at least two parts separated by '/'")
    if not all(parts):
        raise ValueError(f"Invalid name '{interface_name}'. Must not contain empty parts")
    prefix = has_resource("packages", parts[0])
    if not prefix:
        raise LookupError(f"Unknown package '{parts[0]}'")
    path = Path(prefix, "share", *parts)
    if path.suffix:
        file = path if path.exists() else _as_idl(parts[0], path)
    else:
        suffixes = _SUFFIXES.get(parts[-2], (".msg",))
        file = next((p for p in (path.with_suffix(s) for s in suffixes) if p.exists()), None)
    if file is None:
        raise LookupError(f"Could not find the interface '{path if path.suffix else path.with_suffix('.idl')}'")
    return str(file)
