"""Plugins of nav2 that are C++ classes of built packages: a program has the class, and uses the server's node."""

from __future__ import annotations

import struct
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, TypeVar

from rclpy.lifecycle import LifecycleNode, LifecycleState, TransitionCallbackReturn

from coursekit.nodes.compiled.classes import CppFault, PluginFault, Program, check, plugins_of, program_of
from coursekit.nodes.compiled.frames import Unpacker, packed
from coursekit.nodes.compiled.node import GroupsApart
from coursekit.nodes.nav2.parameters import NoPlugin, no_such_plugin

if TYPE_CHECKING:
    from coursekit.nav.costmap import Costmap
    from coursekit.nav.footprint import Footprint
    from coursekit.nodes.nav2.costmap_node import CostmapNode


class CppPlugin:
    """A C++ class, for the server with this node and costmap. Its calls raise CppFault when it throws."""

    served, base, what, created = "", "", "", ""
    """Its kind in `cpp/src/served.cpp`, its base class, and nav2's words for it and its making, of {name} and {kind}."""

    def __init__(self, path: str, type_: str, name: str, node: Any, costmap: Any) -> None:
        self.name, self.node, self.costmap = name, node, costmap
        self._program = Program(path, self.served, type_)
        try:
            self.ask("make")
        except CppFault:
            self._program.close()
            raise

    def configure(self) -> None:
        """Lend it the server's node, buffer and costmap."""
        lent = self.node, self.costmap.where.buffer_for_plugins(), self.costmap
        self.ask("configure", self.name, *map(self.share, lent), rest=self.costs())

    def change(self, what: str) -> None:
        """Call its activate, deactivate or cleanup."""
        self.ask(what)

    def close(self) -> None:
        """End its program."""
        self._program.close()

    def share(self, thing: object) -> int:
        """Let it use an object. Returns the object's number there."""
        return self._program.share(thing)

    def unshare(self, number: int) -> None:
        """Let it use an object no longer."""
        self._program.unshare(number)

    def ask(self, *words: str | int, rest: bytes = b"") -> Unpacker:
        """Let it do something. Raises CppFault."""
        answer = self._program.ask(*words, rest=rest)
        check(answer)
        return answer

    def costs(self) -> bytes:
        """Pack the newest costs and the robot's outline."""
        return packed_costs(self.costmap.latest or self.costmap.layers.costmap, self.costmap.robot)


class CppListeningPlugin(CppPlugin):
    """A C++ class that hears another node's costmap and footprint itself."""

    def configure(self) -> None:
        """Lend it the server's node and buffer; it hears costmap and footprint itself."""
        lent = self.node, self.node.where.buffer_for_plugins()
        self.ask("configure", self.name, *map(self.share, lent))


class PluginsOwner(GroupsApart, LifecycleNode):
    """A managed node that says what a C++ class has thrown as rclcpp's nodes do, and recovers as nav2's."""

    def _rclpy_tell_exception(self, error: Exception, where: str) -> None:
        if not isinstance(error, CppFault):
            super()._rclpy_tell_exception(error, where)
            return
        log = self.get_logger()
        log.error(f"Caught exception in callback for transition {self._state_machine.current_state[0]}")
        log.error(f"Original error: {error}")

    def on_error(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Become unconfigured."""
        self.get_logger().fatal(f"Lifecycle node {self.get_name()} does not have error state implemented")
        return TransitionCallbackReturn.SUCCESS


Kind = TypeVar("Kind", bound=CppPlugin)


class CppPlugins:
    """The C++ classes of a server, by the names of its plugins."""

    def __init__(self, node: PluginsOwner, costmap: CostmapNode | None = None) -> None:
        self._node, self._costmap = node, costmap
        self._all: dict[str, CppPlugin] = {}
        self._logged: set[str] = set()

    def log_created(self, wanted: type[CppPlugin], name: str, kind: str) -> None:
        """Log that a plugin was created."""
        self._log_once(wanted.created.format(name=name, kind=kind))

    def log_available(self, server: str, what: str, names: Iterable[str]) -> None:
        """Log the names of a server's plugins as nav2 does, with a space behind each."""
        self._log_once(f"{server} has {''.join(f'{name} ' for name in names)} {what} available.")

    def _log_once(self, line: str) -> None:
        """Log it at the first configuration only: a parameter that is set creates those in Python again."""
        if line not in self._logged:
            self._logged.add(line)
            self._node.get_logger().info(line)

    def get(self, wanted: type[Kind], name: str, kind: str, known: Iterable[str]) -> Kind:
        """Return a plugin, made and configured the first time; `known` are the classes in Python.

        Raises NoPlugin, and CppFault when the class throws.
        """
        there = self._all.get(name)
        if isinstance(there, wanted):
            return there
        plugin = wanted(*where_is(wanted, name, kind, known), name, self._node, self._costmap)
        self._all[name] = plugin
        self.log_created(wanted, name, kind)
        plugin.configure()
        return plugin

    def change(self, what: str) -> None:
        """Call activate, deactivate or cleanup of all."""
        for part in self._all.values():
            part.change(what)

    def retire(self) -> None:
        """Call cleanup of all, and end their programs."""
        try:
            self.change("cleanup")
        finally:
            self.end()

    def end(self) -> None:
        """End all programs."""
        self._logged.clear()
        while self._all:
            self._all.popitem()[1].close()

    def refused(self, fault: Exception) -> TransitionCallbackReturn:
        """Log why the server cannot be configured, and return FAILURE. A class's exception is raised again."""
        self.end()
        if isinstance(fault, CppFault):
            raise fault
        log = self._node.get_logger()
        (log.fatal if isinstance(fault, NoPlugin) else log.error)(str(fault))
        return TransitionCallbackReturn.FAILURE


def where_is(wanted: type[CppPlugin], name: str, kind: str, known: Iterable[str]) -> tuple[str, str]:
    """Return the program and the type of a C++ class for a plugin. Raises NoPlugin."""
    what = wanted.what.format(name=name, kind=kind)
    try:
        declared = plugins_of(wanted.base.partition("::")[0], wanted.base)
        if kind not in declared:
            raise NoPlugin(no_such_plugin(what, kind, wanted.base, [*known, *declared]))
        return program_of(declared[kind])
    except PluginFault as fault:
        raise NoPlugin(f"Failed to create {what}. Exception: {fault}") from None


def packed_costs(costs: Costmap, robot: Footprint) -> bytes:
    """Pack costs and a robot's outline; `Costmap2DROS::renew` reads them."""
    place = struct.pack("<3d", costs.resolution, costs.x, costs.y)
    cells = packed(*costs.cells.shape, costs.cells.tobytes())
    return place + cells + packed(len(robot.corners)) + robot.corners.astype("<f8").tobytes()
