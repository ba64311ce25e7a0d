"""`ros2 run coursekit_robots practice_meter`: counts the messages that arrive on the robot with each QoS.

The service `/meter/read` returns the number of messages on `/meter/best_effort` and `/meter/reliable`.
"""

from __future__ import annotations

from rclpy.node import Node
from rclpy.qos import HistoryPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import UInt8MultiArray
from std_srvs.srv import Trigger

from coursekit.nodes.running import run

QUALITIES = {
    "best_effort": QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT),
    "reliable": QoSProfile(history=HistoryPolicy.KEEP_ALL, reliability=ReliabilityPolicy.RELIABLE),
}


class Meter(Node):
    """Counts messages by topic."""

    def __init__(self) -> None:
        super().__init__("meter")
        self._came = dict.fromkeys(QUALITIES, 0)
        for name, quality in QUALITIES.items():
            self.create_subscription(UInt8MultiArray, f"~/{name}", lambda _msg, name=name: self._count(name), quality)
        self.create_service(Trigger, "~/read", self._read)

    def _count(self, name: str) -> None:
        self._came[name] += 1

    def _read(self, _request: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
        response.success = True
        response.message = ", ".join(f"{name} {count}" for name, count in self._came.items())
        return response


def main(args: list[str] | None = None) -> int:
    """Count until Ctrl-C."""
    return run(Meter, args)
