"""The topic behavior_tree_log: each change of a tree node's status, as bt_navigator tells it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nav2_msgs.msg import BehaviorTreeLog, BehaviorTreeStatusChange

from coursekit.nav.behavior_tree import TreeNode
from coursekit.nav.tree_blackboard import STATUS_CHANGED, Board

if TYPE_CHECKING:
    from rclpy.node import Node


class TreeLog:
    """Collects the changes of a tick, and publishes them together.

    `watch` gives it to a tree's blackboard, before the tree is ticked.
    """

    def __init__(self, node: Node) -> None:
        self._node = node
        self._changes: list[BehaviorTreeStatusChange] = []
        self._publisher = node.create_publisher(BehaviorTreeLog, "behavior_tree_log", 10)

    def watch(self, board: Board) -> None:
        """Note the changes of this blackboard's tree."""
        board[STATUS_CHANGED] = self._note

    def _note(self, node: TreeNode, before: str, after: str) -> None:
        self._changes.append(
            BehaviorTreeStatusChange(
                timestamp=self._node.get_clock().now().to_msg(), node_name=node.name, uid=node.uid,
                previous_status=before.upper(), current_status=after.upper(),
            )
        )  # fmt: skip

    def flush(self) -> None:
        """Publish what has changed, if anything has."""
        if self._changes:
            now = self._node.get_clock().now().to_msg()
            self._publisher.publish(BehaviorTreeLog(timestamp=now, event_log=self._changes))
            self._changes = []

    def destroy(self) -> None:
        """Destroy the publisher."""
        self._node.destroy_publisher(self._publisher)
