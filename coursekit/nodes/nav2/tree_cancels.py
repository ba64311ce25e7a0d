"""Behaviour tree nodes that cancel all goals of a server, with nav2's names and port."""

from __future__ import annotations

from typing import Any

from action_msgs.srv import CancelGoal

from coursekit.nav.behavior_tree import TreeNode
from coursekit.nodes.nav2.tree_context import context_of
from coursekit.nodes.nav2.tree_services import CallNode


class CancelNode(CallNode):
    """Cancels the goals that the action `server` has accepted so far; there may be none."""

    kind: Any = CancelGoal

    def prepare(self) -> None:
        """Create the client of the action's service."""
        name = self.ports.get("server_name") or self.server
        self.client = context_of(self).service(CancelGoal, f"{name}/_action/cancel_goal")
        self._sent: Any = None

    def request(self) -> Any:
        """All goals up to now."""
        request = CancelGoal.Request()
        request.goal_info.stamp = context_of(self).node.get_clock().now().to_msg()
        return request


CANCELS: dict[str, type[TreeNode]] = {
    f"Cancel{name}": type(f"Cancel{name}", (CancelNode,), {"server": server})
    for name, server in (
        ("AssistedTeleop", "assisted_teleop"), ("BackUp", "backup"), ("Control", "follow_path"),
        ("DriveOnHeading", "drive_on_heading"), ("Spin", "spin"), ("Wait", "wait"),
    )
}  # fmt: skip
"""The nodes by their XML names."""
