"""The map in which frontiers are searched: a topic, and a topic of its updates."""

from __future__ import annotations

from typing import Any

import numpy as np
from map_msgs.msg import OccupancyGridUpdate
from nav_msgs.msg import OccupancyGrid
from rclpy.node import Node

from coursekit.nav.map_file import GridMap
from coursekit.nodes.nav2.map_message import from_message


class CostmapClient:
    """The newest map; None before the first."""

    def __init__(self, node: Node, topic: str, updates: str) -> None:
        self._node, self.frame = node, "map"
        self.grid: GridMap | None = None
        node.create_subscription(OccupancyGrid, topic, self._take, 10)
        node.create_subscription(OccupancyGridUpdate, updates, self._change, 10)
        node.get_logger().info(f"Waiting for costmap to become available, topic: {topic}")

    def _take(self, msg: OccupancyGrid) -> None:
        try:
            self.grid = from_message(msg)
        except ValueError as fault:
            self._node.get_logger().error(f"A map cannot be used: {fault}", throttle_duration_sec=5.0)
            return
        self.frame = msg.header.frame_id

    def _change(self, msg: Any) -> None:
        if self.grid is None:
            return
        rows, columns = slice(msg.y, msg.y + msg.height), slice(msg.x, msg.x + msg.width)
        height, width = self.grid.cells.shape
        fits = 0 <= msg.x <= width - msg.width and 0 <= msg.y <= height - msg.height
        if not fits or len(msg.data) != msg.width * msg.height:
            self._node.get_logger().error(
                f"received update doesn't fully fit into existing map: {msg.width} x {msg.height} at {msg.x}, {msg.y}",
                throttle_duration_sec=5.0,
            )
            return
        self.grid.cells[rows, columns] = np.array(msg.data, np.int8).reshape(msg.height, msg.width)
