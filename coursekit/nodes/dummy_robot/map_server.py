"""`ros2 run dummy_map_server dummy_map_server`: a map with one obstacle that moves cell by cell."""

from __future__ import annotations

from nav_msgs.msg import OccupancyGrid
from rclpy.qos import DurabilityPolicy, QoSProfile

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.running import run

SIDE, RESOLUTION = 100, 0.1  # cells, metres
UNKNOWN, FREE, OCCUPIED = -1, 0, 100


class DummyMapServer(CppNode):
    """Publishes /map each second: unknown except for one occupied cell between two free ones."""

    def __init__(self) -> None:
        super().__init__("dummy_map_server")
        kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self._publisher = self.create_publisher(OccupancyGrid, "map", kept)
        self._first = 0
        self._msg = OccupancyGrid()
        self._msg.header.frame_id = "world"
        info = self._msg.info
        info.resolution, info.width, info.height = RESOLUTION, SIDE, SIDE
        info.origin.position.x = info.origin.position.y = -SIDE * RESOLUTION / 2
        self._publish()
        self.create_timer(1.0, self._publish)

    def _publish(self) -> None:
        self._first += 1
        cells = [UNKNOWN] * (SIDE * SIDE)
        for step, value in enumerate((FREE, OCCUPIED, FREE)):
            cells[(self._first + step) % len(cells)] = value
        self._msg.data = cells
        self._msg.header.stamp = self.get_clock().now().to_msg()
        self._publisher.publish(self._msg)


def main(args: list[str] | None = None) -> int:
    """Publish until Ctrl-C."""
    return run(DummyMapServer, args)
