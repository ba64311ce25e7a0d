"""The map on topics and services."""

from __future__ import annotations

from array import array
from typing import TYPE_CHECKING

from nav_msgs.msg import MapMetaData, OccupancyGrid
from rclpy.node import Node

from coursekit.nav.map_file import GridMap
from coursekit.nodes.nav2.map_message import MAP_QOS
from coursekit.slam import grid as slam_grid

if TYPE_CHECKING:
    from builtin_interfaces.msg import Time as TimeMsg


class MapTopic:
    """Publishes a grid on `name` and its size on `name`_metadata; late subscribers receive the last map."""

    def __init__(self, node: Node, name: str, frame: str) -> None:
        self._grid_publisher = node.create_publisher(OccupancyGrid, name, MAP_QOS)
        self._size_publisher = node.create_publisher(MapMetaData, f"{name}_metadata", MAP_QOS)
        self._frame = frame
        self.latest: OccupancyGrid | None = None

    def publish(self, grid: GridMap, stamp: TimeMsg) -> None:
        """Publish a map with its stamp."""
        msg = OccupancyGrid()
        msg.header.frame_id, msg.header.stamp = self._frame, stamp
        msg.info.resolution = grid.resolution
        msg.info.height, msg.info.width = grid.cells.shape
        msg.info.origin.position.x, msg.info.origin.position.y = grid.origin[:2]
        msg.data = array("b", grid.cells.tobytes())
        self.latest = msg
        self._grid_publisher.publish(msg)
        self._size_publisher.publish(msg.info)


def grid_map(grid: slam_grid.OccupancyGrid) -> GridMap:
    """The library's grid as a nav2 map: -1 unknown, 0 free, 100 wall."""
    return GridMap(grid.trinary(), grid.resolution, (*grid.origin, 0.0))
