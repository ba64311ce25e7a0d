"""A compiled program's requests about plugins declared in XML by workspaces, as read by pluginlib."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple
from xml.etree.ElementTree import Element, ParseError, fromstring

from ament_index_python import get_package_prefix, get_resource, get_resources

from coursekit.files import read_text
from coursekit.nodes.compiled.frames import Unpacker, packed

if TYPE_CHECKING:
    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host


class InvalidManifest(Exception):
    """A plugin description is not valid XML of this kind."""


class Plugin(NamedTuple):
    """A class provided by a library."""

    name: str
    type: str
    library: str
    """The path of its library, or the name in the description if there is no such file; empty for what is in the runtime."""
    description: str
    package: str
    manifest: str


def do_plugins(_host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the plugins for a base class of a package."""
    package, base, attribute = frame.text(), frame.text(), frame.text()
    get_package_prefix(package)  # raises PackageNotFoundError for an unknown package
    paths = [Path(frame.text()) for _ in range(frame.integer())]
    descriptions = map(_with_owner, paths) if paths else _exported(f"{package}__pluginlib__{attribute}")
    plugins = [plugin for description in descriptions for plugin in _read(*description, base)]
    words = [word for plugin in plugins for word in (*plugin, int(os.path.isabs(plugin.library) or not plugin.library))]
    return packed(len(plugins), *words)


def declared(package: str, base: str) -> Iterator[Plugin]:
    """Yield the plugins of all packages for a base class defined by `package`."""
    for description in _exported(f"{package}__pluginlib__plugin"):
        yield from _read(*description, base)


def _exported(kind: str) -> Iterator[tuple[str, Path, Path]]:
    """Yield the descriptions exported under a type of resource: their packages, prefixes and paths."""
    for owner in sorted(get_resources(kind)):
        content, prefix = get_resource(kind, owner)
        for line in content.split():
            yield owner, Path(prefix), Path(prefix, line)


def _with_owner(path: Path) -> tuple[str, Path, Path]:
    """Return the package of a description, whose manifest lies above it, the package's prefix, and the path."""
    for folder in path.parents:
        if (manifest := folder / "package.xml").is_file():
            owner = fromstring(read_text(manifest)).findtext("name", "").strip()
            return owner, Path(get_package_prefix(owner)), path
    raise InvalidManifest(f"Could not find the package of the plugin description {path}: no package.xml lies above it.")


def _read(owner: str, prefix: Path, path: Path, base: str) -> Iterator[Plugin]:
    try:
        root = fromstring(read_text(path))
    except (OSError, ParseError, ValueError) as error:
        text = f"XML Document {path} has no Root Element. This likely means the XML is malformed: {error}"
        raise InvalidManifest(text) from None
    for library in [root] if root.tag == "library" else root.iter("library"):
        for element in library.iter("class"):
            if element.get("base_class_type") == base:
                yield _plugin(owner, prefix, path, library, element)


def _plugin(owner: str, prefix: Path, path: Path, library: Element, element: Element) -> Plugin:
    kind = element.get("type", "")
    text = (element.findtext("description") or "No 'description' tag for this plugin in plugin description file.").strip()
    where = _library(prefix, library.get("path", ""))
    return Plugin(element.get("name") or kind, kind, where, text, owner, str(path))


def _library(prefix: Path, name: str) -> str:
    folder, _, stem = name.rpartition("/")
    for file in (f"lib{stem}.so", f"{stem}.so", f"lib{stem}.dylib"):
        if (path := prefix / (folder or "lib") / file).is_file():
            return str(path)
        if (path := prefix / "lib" / file).is_file():
            return str(path)
    return name
