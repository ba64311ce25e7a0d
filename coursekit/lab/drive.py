"""Driving by hand: keys and sticks become geometry_msgs/Twist messages; without input for a while the robot stops."""

from __future__ import annotations

from typing import Any

from geometry_msgs.msg import Twist

from coursekit.cli.session_client import domain_id
from coursekit.core.graph_node import GraphNode
from coursekit.core.qos import Qos
from coursekit.processes.session import current

from .errors import BadArgument

SILENCE_SECONDS = 0.5
"""Timeout of the browser's input: after it (page closed, computer asleep) the keys count as released [s]."""
BEAT_SECONDS = 0.1
"""The period at which a held key is published [s]."""
KEYS = {
    "up": (1.0, 0.0, 0.0),
    "down": (-1.0, 0.0, 0.0),
    "left": (0.0, 0.0, 1.0),
    "right": (0.0, 0.0, -1.0),
    "strafe left": (0.0, 1.0, 0.0),
    "strafe right": (0.0, -1.0, 0.0),
}
"""The velocity of each key: forward, left, rotation to the left; each from -1 to 1."""


def meaning(keys: str) -> tuple[float, float, float]:
    """Return the velocity of keys held together, for example 'up+left'; ValueError for an unknown key.

    >>> meaning("up+left")
    (1.0, 0.0, 1.0)
    """
    total = [0.0, 0.0, 0.0]
    for key in keys.split("+"):
        if key.strip() not in KEYS:
            raise BadArgument(f"There is no key '{key.strip()}'. Keys are: {', '.join(KEYS)}; join them with '+'.")
        total = [sum(pair) for pair in zip(total, KEYS[key.strip()], strict=True)]
    return total[0], total[1], total[2]


class Driver:
    """Publishes velocities on `topic`; full deflection is `linear` m/s and `angular` rad/s.

    It creates its own graph node. It therefore needs no rclpy.init, and rejoins the graph after `reset()`.
    """

    def __init__(self, topic: str, linear: float, angular: float, node_name: str = "") -> None:
        self.topic = topic if topic.startswith("/") else f"/{topic}"
        self.node_name = node_name or "pad" + self.topic.replace("/", "_")
        self.linear = linear
        self.angular = angular
        self.moving = False
        self._node: GraphNode | None = None
        self._publisher: Any = None
        self._silence: Any = None
        self._far: set[str] = set()

    def join(self) -> Any:
        """Join the graph if necessary, and return the publisher."""
        graph = current().graph(domain_id())
        if self._node is None or self._node not in graph.nodes:
            self._node = graph.add_node(self.node_name, "/")
            self._publisher = self._node.publisher(self.topic, Twist, Qos(depth=1))
        return self._publisher

    def lost(self) -> str:
        """Return the address of remote subscribers that are gone; '' while connected, or if there never were any.

        On a loss this also stops the drive: motion must not resume by itself when the link is back.
        """
        if self._node is None or not self._publisher.alive:
            return ""
        listeners = self._publisher.targets
        far = {listener.node.remote for listener in listeners if listener.node.remote}
        self._far = far or self._far
        if far or not self._far:
            return ""
        self.stop()
        return ", ".join(sorted(self._far))

    def leave(self) -> None:
        """Stop, and leave the graph."""
        self.stop()
        if self._node is not None:
            self._node.close()
            self._node = None

    def drive(self, forward: float, left: float = 0.0, turn: float = 0.0) -> None:
        """Publish one velocity, each component from -1 to 1. Unless repeated, it ends after SILENCE_SECONDS."""
        forward, left, turn = (max(-1.0, min(1.0, float(part))) for part in (forward, left, turn))
        twist = Twist()
        twist.linear.x, twist.linear.y = forward * self.linear, left * self.linear
        twist.angular.z = turn * self.angular
        if self._silence is not None:
            self._silence.cancel()
            self._silence = None
        self.moving = any((forward, left, turn))
        if self.moving:
            clock = current().clock
            self._silence = clock.call_at(clock.steady() + round(SILENCE_SECONDS * 1e9), self.stop)
        self.join().publish(twist)

    def stop(self) -> None:
        """Publish zero if the robot is moving."""
        if self.moving:
            self.drive(0.0)

    def press(self, keys: str = "up", seconds: float = 1.0) -> None:
        """Hold keys ('up', 'up+left', ...) for `seconds` of session time, then release them."""
        forward, left, turn = meaning(keys)
        clock = current().clock
        end = clock.steady() + round(seconds * 1e9)
        try:
            while (remaining := (end - clock.steady()) * 1e-9) > 1e-6:
                self.drive(forward, left, turn)
                clock.sleep(min(BEAT_SECONDS, remaining))
        finally:
            self.stop()

    def hear(self, message: dict[str, Any]) -> bool:
        """Handle a browser message of type "drive". Returns whether it was one."""
        if message.get("type") != "drive":
            return False
        parts = [float(message.get(name) or 0.0) for name in ("x", "y", "turn")]
        if any(parts) or self.moving:
            self.drive(*parts)
        return True
