"""Plugins of nav2 that are C++ classes of built packages: a program has the class, and uses the server's node."""

from __future__ import annotations

import struct
from typing import Any

from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Path
from rclpy.lifecycle import TransitionCallbackReturn

from coursekit.nodes.compiled.classes import CppFault, PluginFault, Program, check, plugins_of, program_of
from coursekit.nodes.compiled.frames import Unpacker, packed
from coursekit.nodes.nav2.costmap_node import CostmapNode
from coursekit.nodes.nav2.parameters import NoPlugin, no_such_plugin


class Foreign:
    """A C++ class with the life of nav2's plugins. Its calls raise CppFault when it throws."""

    def __init__(self, kind: str, where: tuple[str, str], name: str, node: Any, costmap: CostmapNode) -> None:
        """`kind` as `cpp/src/served.cpp` knows it, `where` as `program_of` says it."""
        path, type_ = where
        self.name, self.node, self.costmap = name, node, costmap
        self._program = Program(path, kind, type_)
        try:
            check(self._program.ask("make"))
        except CppFault:
            self._program.close()
            raise

    def configure(self) -> None:
        """Lend it the server's node, buffer and costmap."""
        lent = self.node, self.costmap.where.buffer_for_plugins(), self.costmap
        self.ask("configure", *map(self._program.share, lent), self.name, rest=self._costs())

    def change(self, what: str) -> None:
        """Call its activate, deactivate or cleanup."""
        self.ask(what)

    def close(self) -> None:
        """End its program."""
        self._program.close()

    def ask(self, *words: str | int, rest: bytes = b"") -> Unpacker:
        """Let it do something. Raises CppFault."""
        answer = self._program.ask(*words, rest=rest)
        check(answer)
        return answer

    def _costs(self) -> bytes:
        """Pack the newest costs and the robot's outline; `Costmap2DROS::renew` reads them."""
        costs = self.costmap.latest or self.costmap.layers.costmap
        outline = self.costmap.robot.corners
        return b"".join(
            (
                struct.pack("<3d", costs.resolution, costs.x, costs.y), packed(*costs.cells.shape, costs.cells.tobytes()),
                packed(len(outline)), outline.astype("<f8").tobytes(),
            )
        )  # fmt: skip


class ForeignPlanner(Foreign):
    """A class derived from nav2_core::GlobalPlanner."""

    def plan(self, start: PoseStamped, goal: PoseStamped) -> Path:
        """Call createPlan."""
        path: Path = self.ask("plan", rest=self._costs() + packed(start, goal)).message(Path)
        return path


def where_is(what: str, kind: str, base: str, known: Any) -> tuple[str, str]:
    """Return where a C++ class is, for `Foreign`; `known` are the classes in Python. Raises NoPlugin."""
    package = base.partition("::")[0]
    try:
        declared = plugins_of(package, base)
        if kind not in declared:
            raise NoPlugin(no_such_plugin(what, kind, base, [*known, *declared]))
        return program_of(declared[kind])
    except PluginFault as fault:
        raise NoPlugin(f"Failed to create {what}. Exception: {fault}") from None


def refused(node: Any, fault: Exception) -> TransitionCallbackReturn:
    """Log why a server cannot be configured, and return FAILURE. An exception of a C++ class is raised again."""
    if isinstance(fault, CppFault):
        raise fault
    log = node.get_logger()
    (log.fatal if isinstance(fault, NoPlugin) else log.error)(str(fault))
    return TransitionCallbackReturn.FAILURE


def end_programs(plugins: dict[str, Any]) -> None:
    """Empty a server's plugins, and end the programs of C++ classes."""
    while plugins:
        _, one = plugins.popitem()
        if isinstance(one, Foreign):
            one.close()


def retire(plugins: dict[str, Any]) -> None:
    """Empty a server's plugins, with cleanup of the C++ classes among them."""
    try:
        change_all(plugins.values(), "cleanup")
    finally:
        end_programs(plugins)


def change_all(plugins: Any, what: str) -> None:
    """Call activate, deactivate or cleanup of all C++ classes among some plugins."""
    for one in plugins:
        if isinstance(one, Foreign):
            one.change(what)
