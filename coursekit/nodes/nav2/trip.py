"""Navigation to a goal with a user's behaviour tree."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from geometry_msgs.msg import PoseStamped
from rclpy.action import ActionClient
from rclpy.logging import get_logger
from std_msgs.msg import String
from tf2_ros import TransformException

from coursekit.files import installed
from coursekit.geometry.plane import Pose2D
from coursekit.nav.behavior_tree import RUNNING, SUCCESS, Kinds, TreeError, TreeNode, read_tree
from coursekit.nav.planner import length
from coursekit.nav.second_thoughts import remaining
from coursekit.nav.tree_branches import BRANCHES
from coursekit.nav.tree_controls import CONTROLS
from coursekit.nodes.compiled.classes import CppFault
from coursekit.nodes.nav2.condition_nodes import CONDITIONS
from coursekit.nodes.nav2.map_message import MAP_QOS
from coursekit.nodes.nav2.running import Beat
from coursekit.nodes.nav2.tree_actions import ACTIONS
from coursekit.nodes.nav2.tree_cancels import CANCELS
from coursekit.nodes.nav2.tree_watchers import WATCHERS
from coursekit.nodes.scanning.planar import points_of

if TYPE_CHECKING:
    from rclpy.node import Node
    from rclpy.qos import QoSProfile

    from coursekit.nodes.nav2.tree_log import TreeLog

KINDS: dict[str, type[TreeNode]] = {**CONTROLS, **BRANCHES, **ACTIONS, **CANCELS, **CONDITIONS, **WATCHERS}
MOST_BYTES = 2**20


class Crew:
    """The resources that the trees' nodes share: clients, messages, and the robot's pose."""

    def __init__(self, node: Node, where: Callable[[], Pose2D | None], place_of: Callable[[PoseStamped], Pose2D]) -> None:
        self.node, self.pose, self._place_of = node, where, place_of
        self.goes_on = False
        """Whether a newer goal replaces this one; the robot is then not stopped in between."""
        self._clients: dict[tuple[Any, str], Any] = {}
        self._heard: dict[str, tuple[Any, deque[Any]]] = {}

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

    def listen(self, topic: str, kind: type[Any] = PoseStamped, qos: QoSProfile | int = 10) -> deque[Any]:
        """A queue with the newest message of a topic, or empty."""
        if topic not in self._heard:
            kept: deque[Any] = deque(maxlen=1)
            self._heard[topic] = self.node.create_subscription(kind, topic, kept.append, qos), kept
        return self._heard[topic][1]

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


def load_tree(file: str, crew: Crew, goals: list[PoseStamped], kinds: Kinds = KINDS) -> TreeNode:
    """Load the tree of a file for these goals; raises TreeError with the file, the fault and its remedy."""
    try:
        with Path(installed(file)).open("rb") as stream:
            text = stream.read(MOST_BYTES).decode()
    except (OSError, ValueError) as fault:
        reason = getattr(fault, "strerror", None) or "it is no text"
        raise TreeError(f"Couldn't open input XML file: {file} ({reason}): name a behaviour tree's .xml in full") from None
    try:
        return read_tree(text, kinds, {"crew": crew, "goal": goals[-1] if goals else None, "goals": goals})
    except TreeError as fault:
        raise TreeError(f"Error loading XML file: {file} {fault}") from None


class Trip:
    """Navigation to one goal with a tree: `await run()` returns 'succeeded', 'failed' or 'stopped' (when `stop()` is true).

    `tell(trip)` is called ten times a second, `goes_on()` at the end: whether a newer goal keeps the robot moving.
    """

    def __init__(
        self, tree: TreeNode, crew: Crew, stop: Callable[[], bool], goes_on: Callable[[], bool],
        tell: Callable[[Trip], None], period: float, log: TreeLog | None = None,
    ) -> None:  # fmt: skip
        self._log = log
        if log is not None:
            log.watch(tree.board)
        self._goes_on = goes_on
        self.tree, self.crew, self._stop, self._tell, self._period = tree, crew, stop, tell, period

    @property
    def goals(self) -> list[PoseStamped]:
        """The remaining goals."""
        return list(self.tree.board["goals"])

    @property
    def recoveries(self) -> int:
        """The number of recoveries."""
        return int(self.tree.board.get("number_recoveries", 0))

    @property
    def distance(self) -> float:
        """The remaining length of the path [m]."""
        here, path = self.crew.pose(), self.tree.board.get("path")
        if here is None or path is None or not path.poses:
            return 0.0
        return length(remaining(points_of(path), here.x, here.y))

    async def run(self) -> str:
        """Run the tree to its end: 'succeeded', 'failed' or 'stopped'."""
        beat, told, abandoned = Beat(self.crew.node, self._period), -math.inf, False
        try:
            while not self._stop():
                status = self.tree.tick()
                self._flush()
                if status != RUNNING:
                    return "succeeded" if status == SUCCESS else "failed"
                if self.crew.seconds() - told >= 0.1:
                    told = self.crew.seconds()
                    self._tell(self)
                await beat.next()
            return "stopped"
        except (TreeError, CppFault) as fault:
            get_logger("BehaviorTreeEngine").error(f"Behavior tree threw exception: {fault}. Exiting with failure.")
            return "failed"
        except GeneratorExit:  # collected long after its node was destroyed: there is nothing left to stop or to report to
            abandoned = True
            raise
        finally:
            if not abandoned:
                beat.stop()
                self.crew.goes_on = self._goes_on()
                self.tree.halt()
                self._flush()
                self.tree.retire()

    def _flush(self) -> None:
        if self._log is not None:
            self._log.flush()
