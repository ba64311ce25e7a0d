"""A costmap's input from a sensor topic, and the input from scans."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from geometry_msgs.msg import TransformStamped
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import LaserScan
from tf2_ros import TransformException

from coursekit.nav.obstacles import ObstacleLayer
from coursekit.nodes.nav2.transform_lookup import TransformLookup
from coursekit.nodes.scanning.planar import fault_of, of_transform, upside_down
from coursekit.nodes.scanning.scan_filter import ScanFilter, lookup

if TYPE_CHECKING:
    from rclpy.node import Node

    from coursekit.nav.costmap import Costmap


class Source:
    """Marks and clears a layer with the messages of a topic, once tf has the sensor's pose at their time."""

    kind: Any
    what: str
    """The type of its messages, and the word for one in log messages."""

    def __init__(self, node: Node, where: TransformLookup, frame: str, layer: ObstacleLayer, given: dict[str, Any]) -> None:
        self.node, self.layer, self.given, self._where, self._frame = node, layer, given, where, frame
        self.filter = ScanFilter(node, where.buffer, frame, 10, self._take)
        self._heard = node.create_subscription(
            self.kind, in_server_space(node, given["topic"]), self.filter.add, qos_profile_sensor_data
        )

    def close(self) -> None:
        """Destroy the subscription."""
        self.node.destroy_subscription(self._heard)

    def fault(self, msg: Any) -> str:
        """The reason why a message cannot be used; empty if it can."""
        raise NotImplementedError

    def see(self, msg: Any, seat: TransformStamped) -> None:
        """Mark and clear with a message of a sensor at the pose `seat`."""
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
    """Marks obstacles where beams ended and clears the space before them, if the laser's height is within the limits."""

    kind, what = LaserScan, "scan"

    def fault(self, msg: LaserScan) -> str:
        """The reason why a scan cannot be used; empty if it can."""
        return fault_of(msg)

    def see(self, msg: LaserScan, seat: TransformStamped) -> None:
        """Mark and clear with a scan of a laser at the pose `seat`."""
        if not self._counts(seat.transform.translation.z):
            return
        laser = of_transform(seat)
        ends, hits = self._ends(msg, upside_down(seat.transform.rotation))
        self.layer.see((laser.x, laser.y), laser.transform(ends), hits, clearing=self.given["clearing"])

    def _counts(self, height: float) -> bool:
        """Whether the height [m] is within the limits. ROS 2 ignores other scans silently; here a warning explains it."""
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
        """The end points of the valid beams in the laser's frame [m], and which of them to mark as obstacles."""
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


def layer_of(like: Costmap, given: list[dict[str, Any]]) -> ObstacleLayer:
    """An empty layer with the largest marking and clearing ranges among its sources."""
    mark = max((source["obstacle_max_range"] for source in given), default=math.inf)
    return ObstacleLayer(like, mark, max((source["raytrace_max_range"] for source in given), default=math.inf))


def in_server_space(node: Node, topic: str) -> str:
    """Resolve a topic in the namespace of the costmap's server: relative names do not start in the costmap's own namespace.

    >>> from types import SimpleNamespace
    >>> in_server_space(SimpleNamespace(get_namespace=lambda: "/robot/local_costmap"), "scan")
    '/robot/scan'
    """
    return topic if topic.startswith("/") else f"{node.get_namespace().rpartition('/')[0]}/{topic}"
