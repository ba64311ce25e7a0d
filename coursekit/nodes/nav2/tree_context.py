"""What the nodes of a behaviour tree share."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from geometry_msgs.msg import PoseStamped
from rclpy.action import ActionClient
from std_msgs.msg import String
from tf2_ros import TransformException

from coursekit.geometry.plane import Pose2D
from coursekit.nav.behavior_tree import TreeError, TreeNode
from coursekit.nodes.nav2.map_message import MAP_QOS

if TYPE_CHECKING:
    from rclpy.node import Node
    from rclpy.qos import QoSProfile


class TreeContext:
    """The resources that the trees' nodes share: clients, messages, and the robot's pose."""

    def __init__(
        self, node: Node, where: Callable[[], Pose2D | None], place_of: Callable[[PoseStamped], Pose2D],
        knows: Callable[[str, str], bool], speed: Callable[[], float] = lambda: 0.0,
    ) -> None:  # fmt: skip
        self.node, self.pose, self._place_of = node, where, place_of
        self.knows = knows
        """Whether there is a transform to a frame from another one."""
        self.speed = speed
        """How fast the robot drives [m/s]."""
        self.driven: Any = None
        """The path on which the robot is being driven."""
        self._clients: dict[tuple[Any, str], Any] = {}
        self._heard: dict[tuple[str, int], tuple[Any, deque[Any]]] = {}

    def client(self, kind: type[Any], name: str) -> ActionClient:
        """The client of an action."""
        if (kind, name) not in self._clients:
            self._clients[kind, name] = ActionClient(self.node, kind, name)
        client: ActionClient = self._clients[kind, name]
        return client

    def service(self, kind: type[Any], name: str) -> Any:
        """The client of a service."""
        if (kind, name) not in self._clients:
            self._clients[kind, name] = self.node.create_client(kind, name)
        return self._clients[kind, name]

    def listen(self, topic: str, kind: type[Any] = PoseStamped, qos: QoSProfile | int = 10, most: int = 1) -> deque[Any]:
        """A queue with the newest messages of a topic, `most` at most, or empty."""
        if (topic, most) not in self._heard:
            kept: deque[Any] = deque(maxlen=most)
            self._heard[topic, most] = self.node.create_subscription(kind, topic, kept.append, qos), kept
        return self._heard[topic, most][1]

    def listen_to_text(self, topic: str) -> list[str]:
        """A list with the newest text of a topic, or empty."""
        return [msg.data for msg in self.listen(topic, String, MAP_QOS)]

    def error(self, text: str) -> None:
        """Log an error."""
        self.node.get_logger().error(text)

    def seconds(self) -> float:
        """The current time [s]."""
        return float(self.node.get_clock().now().nanoseconds * 1e-9)

    def gap(self, goal: PoseStamped) -> float:
        """The distance from the robot to a pose [m]; infinite if the transform is missing."""
        here = self.pose()
        try:
            return math.inf if here is None else here.distance(self._place_of(goal))
        except TransformException:
            return math.inf

    def destroy(self) -> None:
        """Destroy the clients and subscriptions."""
        for client in self._clients.values():
            client.destroy() if isinstance(client, ActionClient) else self.node.destroy_client(client)
        for subscription, _ in self._heard.values():
            self.node.destroy_subscription(subscription)
        self._clients.clear()
        self._heard.clear()


def context_of(node: TreeNode) -> TreeContext:
    """Return what a node of a tree shares with the others: it stands in the blackboard where nav2 has its ROS node.

    Raises TreeError in a subtree with a blackboard of its own, as on a robot.
    """
    tree_context: TreeContext | None = node.board.get("node")
    if tree_context is None:
        text = "Blackboard::get() error. Missing key [node]"
        hint = 'write <SubTree ID="..." __shared_blackboard="true"/> for the subtree that it is in'
        raise TreeError(f"{text} ({node.name}: {hint})")
    return tree_context
