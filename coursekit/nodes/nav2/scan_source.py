"""A topic of a sensor as a costmap takes it in, and that of scans."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from geometry_msgs.msg import TransformStamped
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import LaserScan
from tf2_ros import TransformException

from coursekit.nav.obstacles import ObstacleLayer
from coursekit.nodes.nav2.whereabouts import Whereabouts
from coursekit.nodes.scanning.planar import fault_of, of_transform, upside_down
from coursekit.nodes.scanning.scan_filter import ScanFilter, lookup


class Source:
    """Marks and clears a layer with the messages of a topic, once tf knows where they were taken."""

    kind: Any
    what: str
    """The type of its messages, and what a sentence calls one."""

    def __init__(self, node: Any, where: Whereabouts, frame: str, layer: ObstacleLayer, given: dict[str, Any]) -> None:
        self.node, self.layer, self.given, self._where, self._frame = node, layer, given, where, frame
        self.filter = ScanFilter(node, where.buffer, frame, 10, self._take)
        self._heard = node.create_subscription(
            self.kind, in_server_space(node, given["topic"]), self.filter.add, qos_profile_sensor_data
        )

    def close(self) -> None:
        """Listen no more."""
        self.node.destroy_subscription(self._heard)

    def fault(self, msg: Any) -> str:
        """Why a message cannot be used; empty when it can."""
        raise NotImplementedError

    def see(self, msg: Any, seat: TransformStamped) -> None:
        """Mark and clear with a message of a sensor that sits there."""
        raise NotImplementedError

    def _take(self, msg: Any) -> None:
        fault = self.fault(msg)
        if fault:
            self.node.get_logger().error(f"A {self.what} of {self.given['topic']} cannot be used: {fault}", once=True)
            return
        try:
            seat = lookup(self._where.buffer, self._frame, msg.header.frame_id, msg.header.stamp)
        except TransformException:
            return
        self.see(msg, seat)


class ScanSource(Source):
    """Scans: an obstacle where a beam ended, free space where it passed, if the laser is at a height that counts."""

    kind, what = LaserScan, "scan"

    def fault(self, msg: LaserScan) -> str:
        """Why a scan cannot be used; empty when it can."""
        return fault_of(msg)

    def see(self, msg: LaserScan, seat: TransformStamped) -> None:
        """Mark and clear with a scan of a laser that sits there."""
        if not self._counts(seat.transform.translation.z):
            return
        laser = of_transform(seat)
        ends, hits = self._ends(msg, upside_down(seat.transform.rotation))
        self.layer.see((laser.x, laser.y), laser.transform(ends), hits, clearing=self.given["clearing"])

    def _counts(self, height: float) -> bool:
        """Whether the height [m] is one of those that count; a robot says nothing where it is not, and sees nothing."""
        lowest, highest = self.given["min_obstacle_height"], self.given["max_obstacle_height"]
        if lowest <= height <= highest:
            return True
        self.node.get_logger().warning(
            f"Scans of {self.given['topic']} do not count: the laser is {height:.2f} m above {self._frame}, and "
            f"{self.given['name']} has min_obstacle_height {lowest}, max_obstacle_height {highest}. "
            "Give the height up to which they count, as max_obstacle_height: 2.0",
            once=True,
        )
        return False

    def _ends(self, scan: LaserScan, flipped: bool) -> tuple[np.ndarray, np.ndarray]:
        """Where the beams that tell something end, in the laser's frame [m], and which of them are obstacles to mark."""
        ranges = np.asarray(scan.ranges, dtype=np.float64)
        angles = (scan.angle_min + scan.angle_increment * np.arange(len(ranges))) * (-1 if flipped else 1)
        farthest = scan.range_max if scan.range_max > 0 else 1e3
        lost = np.isposinf(ranges) & self.given["inf_is_valid"]
        with np.errstate(invalid="ignore"):
            hit = np.isfinite(ranges) & (ranges >= scan.range_min) & (ranges < farthest)
        used = hit | lost
        length = np.where(lost, farthest, np.nan_to_num(ranges, posinf=farthest, neginf=0.0))[used]
        marks = hit[used] & (length >= self.given["obstacle_min_range"]) & self.given["marking"]
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
