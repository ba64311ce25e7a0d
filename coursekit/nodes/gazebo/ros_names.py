"""The names in a plugin's <ros> element: node, namespace, remappings."""

from __future__ import annotations

from dataclasses import dataclass

from coursekit.urdf.xml_tree import Element


@dataclass(frozen=True)
class RosNames:
    """The `<ros>` block of a plugin.

    >>> RosNames("scan", "", (("~/out", "scan"),)).topic("~/out")
    '/scan'
    >>> RosNames("scan", "robot1").topic("~/out")
    '/robot1/scan/out'
    """

    node: str
    namespace: str = ""
    remappings: tuple[tuple[str, str], ...] = ()

    @property
    def full_node(self) -> str:
        """The full name of its node."""
        return self._full("~")

    def topic(self, name: str) -> str:
        """Return the full name of a topic called `name` in the plugin."""
        wanted = self._full(name)
        for old, new in self.remappings:
            if self._full(old) == wanted:
                return self._full(new)
        return wanted

    def _full(self, name: str) -> str:
        space = "/" + self.namespace.strip("/") if self.namespace.strip("/") else ""
        if name.startswith("/"):
            return name
        if name.startswith("~"):
            return f"{space}/{self.node}/{name[1:].lstrip('/')}".rstrip("/")
        return f"{space}/{name}"


def names_of(plugin: Element, namespace: str = "") -> RosNames:
    """Return the names of a plugin; a `namespace` from spawning its model overrides its own."""
    ros = plugin.first("ros")
    node = (plugin.get("name") or "plugin").replace(" ", "_")
    if ros is None:
        return RosNames(node, namespace or plugin.tell("robotNamespace"))
    pairs = []
    for element in [*ros.all("remapping"), *ros.all("argument")]:
        words = element.text.strip().removeprefix("-r").strip().split(":=")
        if len(words) == 2:
            pairs.append((words[0].strip(), words[1].strip()))
    return RosNames(node, namespace or ros.tell("namespace"), tuple(pairs))


__all__ = ["RosNames", "names_of"]
