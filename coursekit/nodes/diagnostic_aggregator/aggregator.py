"""`ros2 run diagnostic_aggregator aggregator_node`: /diagnostics in groups, on /diagnostics_agg."""

from __future__ import annotations

from typing import Any

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from rclpy.node import Node
from std_msgs.msg import Header

from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.running import run

from .analyzers import OtherAnalyzer, joined
from .group import AnalyzerGroup
from .status import ERROR, STALE, Item

_DEFAULTS = {"path": "", "pub_rate": 1.0, "other_as_errors": False, "history_depth": 1000}


class Aggregator(Node):
    """Publishes all statuses below the paths of the analyzers in its parameters, and the worst level of all."""

    def __init__(self) -> None:
        super().__init__(
            "analyzers", allow_undeclared_parameters=True, automatically_declare_parameters_from_overrides=True
        )
        given = declare(self, _DEFAULTS)
        base, now = joined("", given["path"]), self.get_clock().now().nanoseconds
        self._group = AnalyzerGroup(base, given["path"], self._tree(), now, self.get_logger())
        self._other = OtherAnalyzer(base, as_errors=given["other_as_errors"])
        self._warned: set[str] = set()
        self.create_subscription(DiagnosticArray, "/diagnostics", self._hear, given["history_depth"])
        self._out = self.create_publisher(DiagnosticArray, "/diagnostics_agg", 1)
        self._worst = self.create_publisher(DiagnosticStatus, "/diagnostics_toplevel_state", 1)
        self.create_timer(1.0 / given["pub_rate"], self._publish)

    def _tree(self) -> dict[str, Any]:
        """Return the parameters with a dictionary for each part of their names."""
        tree: dict[str, Any] = {}
        for full, parameter in self.get_parameters_by_prefix("").items():
            *parts, last = full.split(".")
            inner = tree
            for part in parts:
                inner = inner.setdefault(part, {})
            inner[last] = parameter.value
        return tree

    def _hear(self, msg: DiagnosticArray) -> None:
        now = self.get_clock().now().nanoseconds
        self._check_stamp(msg)
        for status in msg.status:
            item = Item.of(status, now)
            if not self._group.take(item):
                self._other.take(item)

    def _check_stamp(self, msg: DiagnosticArray) -> None:
        if msg.header.stamp.sec or msg.header.stamp.nanosec:
            return
        names = ", ".join(status.name for status in msg.status)
        text = f"No timestamp set for diagnostic message. Message names: {names}"
        if text not in self._warned:
            self._warned.add(text)
            self.get_logger().warning(text)

    def _publish(self) -> None:
        now = self.get_clock().now()
        statuses = [*self._group.report(now.nanoseconds), *self._other.report(now.nanoseconds)]
        self._out.publish(DiagnosticArray(status=statuses, header=Header(stamp=now.to_msg())))
        levels = [status.level[0] for status in statuses]
        worst = max(levels, default=STALE)
        worst = ERROR if worst == STALE and min(levels, default=STALE) < STALE else worst
        self._worst.publish(DiagnosticStatus(name="toplevel_state", level=bytes([worst])))


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(Aggregator, args)
