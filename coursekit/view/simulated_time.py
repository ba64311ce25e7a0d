"""The time of a simulation, for a viewer: its frames, and the goals that are set in it, are of that time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rclpy.node import Node

LOOK_SECONDS = 1.0
"""The period of looking whether there is a simulation's clock [s]."""


class SimulatedTime:
    """Read from /clock while somebody publishes it; otherwise the node's own time.

    The last message is read when the time is asked for: a callback for each, as `use_sim_time` has it, wakes the viewer
    a hundred times a second.
    """

    def __init__(self, node: Node) -> None:
        from rclpy.clock import Clock, ClockType

        self._node = node
        self._subscription: Any = None
        self._look()
        node.create_timer(LOOK_SECONDS, self._look, clock=Clock(clock_type=ClockType.STEADY_TIME))

    def now(self) -> int:
        """Return the time [ns]."""
        subscription = self._subscription
        if subscription is not None and (queue := subscription.handle.core.queue):
            stamp = queue[-1][0].clock
            return int(stamp.sec * 1_000_000_000 + stamp.nanosec)
        return int(self._node.get_clock().now().nanoseconds)

    def _look(self) -> None:
        simulated = self._node.count_publishers("/clock") > 0
        if simulated and self._subscription is None:
            self._subscription = self._subscribed()
        elif not simulated and self._subscription is not None:
            self._node.destroy_subscription(self._subscription)
            self._subscription = None

    def _subscribed(self) -> Any:
        from rclpy.qos import QoSProfile, ReliabilityPolicy
        from rosgraph_msgs.msg import Clock

        quality = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
        subscription = self._node.create_subscription(Clock, "/clock", lambda _msg: None, quality)
        subscription.handle.core.attach(None, None)  # no executor wakes up for it
        return subscription


__all__ = ["SimulatedTime"]
