"""A scan topic as a costmap takes it in."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import LaserScan
from tf2_ros import TransformException

from coursekit.nav.obstacles import ObstacleLayer
from coursekit.nodes.nav2.whereabouts import Whereabouts
from coursekit.nodes.scanning.planar import fault_of, of_transform, upside_down
from coursekit.nodes.scanning.scan_filter import ScanFilter, lookup


class ScanSource:
    """Marks and clears a layer with the scans of a topic, once tf knows where they were taken."""

    def __init__(self, node: Any, where: Whereabouts, frame: str, layer: ObstacleLayer, given: dict[str, Any]) -> None:
        self.node, self.layer, self._where, self._frame, self._given = node, layer, where, frame, given
        self.filter = ScanFilter(node, where.buffer, frame, 10, self._take)
        self._heard = node.create_subscription(
            LaserScan, in_server_space(node, given["topic"]), self.filter.add, qos_profile_sensor_data
        )

    def close(self) -> None:
        """Listen no more."""
        self.node.destroy_subscription(self._heard)

    def _take(self, scan: LaserScan) -> None:
        fault = fault_of(scan)
        if fault:
            self.node.get_logger().error(f"A scan of {self._given['topic']} cannot be used: {fault}", once=True)
            return
        try:
            seat = lookup(self._where.buffer, self._frame, scan.header.frame_id, scan.header.stamp)
        except TransformException:
            return
        laser = of_transform(seat)
        ends, hits = self._ends(scan, upside_down(seat.transform.rotation))
        ends = laser.transform(ends)
        self.layer.see((laser.x, laser.y), ends, hits, clearing=self._given["clearing"])

    def _ends(self, scan: LaserScan, flipped: bool) -> tuple[np.ndarray, np.ndarray]:
        """Where the beams that tell something end, in the laser's frame [m], and which of them are obstacles to mark."""
        ranges = np.asarray(scan.ranges, dtype=np.float64)
        angles = (scan.angle_min + scan.angle_increment * np.arange(len(ranges))) * (-1 if flipped else 1)
        farthest = scan.range_max if scan.range_max > 0 else 1e3
        lost = np.isposinf(ranges) & self._given["inf_is_valid"]
        with np.errstate(invalid="ignore"):
            hit = np.isfinite(ranges) & (ranges >= scan.range_min) & (ranges < farthest)
        used = hit | lost
        length = np.where(lost, farthest, np.nan_to_num(ranges, posinf=farthest, neginf=0.0))[used]
        marks = hit[used] & (length >= self._given["obstacle_min_range"]) & self._given["marking"]
        return np.column_stack([length * np.cos(angles[used]), length * np.sin(angles[used])]), marks


def layer_of(like: Any, given: list[dict[str, Any]]) -> ObstacleLayer:
    """An empty layer that marks and clears as far as the farthest of its sources."""
    mark = max((one["obstacle_max_range"] for one in given), default=math.inf)
    return ObstacleLayer(like, mark, max((one["raytrace_max_range"] for one in given), default=math.inf))


def in_server_space(node: Any, topic: str) -> str:
    """A topic as the server around a costmap means it: relative names do not begin in the costmap's own namespace.

    >>> from types import SimpleNamespace
    >>> in_server_space(SimpleNamespace(get_namespace=lambda: "/robot/local_costmap"), "scan")
    '/robot/scan'
    """
    return topic if topic.startswith("/") else f"{node.get_namespace().rpartition('/')[0]}/{topic}"
