"""A topic of point clouds, such as from depth cameras, as a source of a costmap."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import PointCloud2
from sensor_msgs_py.point_cloud2 import read_points
from tf2_sensor_msgs.tf2_sensor_msgs import transform_points

from coursekit.geometry.plane import Array
from coursekit.nodes.nav2.scan_source import Source

if TYPE_CHECKING:
    from rclpy.node import Node

    from coursekit.nav.obstacles import ObstacleLayer
    from coursekit.nodes.nav2.transform_lookup import TransformLookup


class CloudSource(Source):
    """Points between two heights are obstacles, and the space in front of them is free; others are ignored, as in nav2."""

    kind, what = PointCloud2, "cloud"

    def __init__(self, node: Node, where: TransformLookup, frame: str, layer: ObstacleLayer, given: dict[str, Any]) -> None:
        super().__init__(node, where, frame, layer, given)
        if given["max_obstacle_height"] <= given["min_obstacle_height"]:
            node.get_logger().warning(
                f"{given['name']}.max_obstacle_height is {given['max_obstacle_height']}, not above min_obstacle_height: no "
                "point of its clouds is an obstacle. Give the height up to which they count, as max_obstacle_height: 2.0"
            )

    def fault(self, msg: PointCloud2) -> str:
        """Return why a cloud cannot be used, or '' if it can."""
        names = {field.name for field in msg.fields}
        if not names >= {"x", "y", "z"}:
            return f"its fields are {', '.join(sorted(names)) or 'none'}; x, y and z are needed"
        short = len(msg.data) < msg.point_step * msg.width * msg.height
        return f"it has {len(msg.data)} bytes for {msg.width} x {msg.height} points of {msg.point_step}" if short else ""

    def see(self, msg: PointCloud2, seat: TransformStamped) -> None:
        """Mark and clear with a point cloud from a sensor at this pose."""
        points = transform_points(points_of(msg), seat)
        given, high = self.given, points[:, 2]
        counted = points[(high >= given["min_obstacle_height"]) & (high <= given["max_obstacle_height"])]
        here = seat.transform.translation
        ends = self._one_a_cell(counted[:, :2])
        far = np.hypot(*(ends - (here.x, here.y)).T) >= given["obstacle_min_range"]
        self.layer.see((here.x, here.y), ends, far & given["marking"], clearing=given["clearing"])

    def _one_a_cell(self, ends: Array) -> Array:
        """Return one point per occupied cell: a camera has thousands of points, and a costmap few cells."""
        grid = self.layer.map
        cells = np.floor((ends - (grid.x, grid.y)) / grid.resolution).astype(np.int64)
        _, first = np.unique(cells, axis=0, return_index=True)
        return ends[first]


def points_of(msg: PointCloud2) -> Array:
    """Return a cloud's finite points, (n, 3) [m]."""
    table = read_points(msg, field_names=["x", "y", "z"])
    points = np.column_stack([np.asarray(table[axis], float).ravel() for axis in "xyz"])
    finite: Array = points[np.isfinite(points).all(axis=1)]
    return finite


__all__ = ["CloudSource", "points_of"]
