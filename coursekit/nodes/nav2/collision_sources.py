"""What a collision monitor's sensors measure, as points around the robot."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from geometry_msgs.msg import TransformStamped
from rclpy.qos import qos_profile_sensor_data
from rclpy.time import Time
from sensor_msgs.msg import LaserScan, PointCloud2, Range
from tf2_ros import TransformException
from tf2_sensor_msgs.tf2_sensor_msgs import transform_points

from coursekit.geometry.plane import Array
from coursekit.nodes.nav2.cloud_source import points_of
from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.nav2.transform_lookup import TransformLookup
from coursekit.nodes.scanning.planar import ends_of, of_transform
from coursekit.nodes.scanning.scan_filter import lookup

if TYPE_CHECKING:
    from rclpy.node import Node

NOTHING = np.zeros((0, 2))
_KINDS = {"scan": LaserScan, "pointcloud": PointCloud2, "range": Range}
_SOURCE = {"type": "scan", "topic": "scan", "enabled": True}
_CLOUD = {"min_height": 0.05, "max_height": 0.5}
_RANGE = {"obstacles_angle": math.pi / 180}


class SensorSource:
    """Keeps a sensor's latest message; `points` are what it saw, relative to where the robot is now."""

    def __init__(self, node: Node, where: TransformLookup, name: str, settings: dict[str, Any]) -> None:
        self.node, self.where, self.name, self.settings = node, where, name, settings
        given = declare(node, _SOURCE, name)
        if given["type"] not in _KINDS:
            raise ValueError(f"[{name}]: Unknown source type: {given['type']}. Write one of {', '.join(_KINDS)}")
        self.kind = given["type"]
        more = {"scan": {}, "pointcloud": _CLOUD, "range": _RANGE}[self.kind]
        self.given = given | declare(node, more, name)
        self._newest: Any = None
        self._heard = node.create_subscription(_KINDS[self.kind], given["topic"], self._hear, qos_profile_sensor_data)

    def _hear(self, msg: LaserScan | PointCloud2 | Range) -> None:
        self._newest = msg

    def close(self) -> None:
        """Drop the subscription."""
        self.node.destroy_subscription(self._heard)

    def points(self) -> Array:
        """Return the latest points, (n, 2) in the robot's frame [m]; none if they are too old, or tf is missing."""
        msg = self._newest
        if msg is None or not self.node.get_parameter(f"{self.name}.enabled").value:
            return NOTHING
        late = (self.node.get_clock().now().nanoseconds - Time.from_msg(msg.header.stamp).nanoseconds) * 1e-9
        if abs(late) > self.settings["source_timeout"]:
            self.node.get_logger().warning(
                f"[{self.name}]: Latest source and current collision monitor node timestamps differ on {late:f} seconds. "
                "Ignoring the source."
            )
            return NOTHING
        try:
            return self._around_robot(msg)
        except (TransformException, AssertionError, ValueError, KeyError) as fault:
            self.node.get_logger().error(f"[{self.name}]: Failed to get its points: {fault}")
            return NOTHING

    def _around_robot(self, msg: LaserScan | PointCloud2 | Range) -> Array:
        buffer, base, odom = self.where.buffer, self.settings["base_frame_id"], self.settings["odom_frame_id"]
        seat = lookup(buffer, base, msg.header.frame_id, msg.header.stamp)
        seen = self._seen(msg, seat)
        if not self.settings["base_shift_correction"]:
            return seen
        then = of_transform(lookup(buffer, odom, base, msg.header.stamp))
        return (self.where.robot(odom).inverse() @ then).transform(seen)

    def _seen(self, msg: LaserScan | PointCloud2 | Range, seat: TransformStamped) -> Array:
        if isinstance(msg, PointCloud2):
            points = transform_points(points_of(msg), seat)
            return points[(points[:, 2] >= self.given["min_height"]) & (points[:, 2] <= self.given["max_height"])][:, :2]
        flat = _of_scan(msg) if isinstance(msg, LaserScan) else _of_range(msg, self.given["obstacles_angle"])
        return transform_points(flat, seat)[:, :2]


def _of_scan(msg: LaserScan) -> Array:
    ranges = np.asarray(msg.ranges, float)
    good = (ranges >= msg.range_min) & (ranges <= msg.range_max)
    return ends_of(ranges[good], (msg.angle_min + msg.angle_increment * np.arange(len(ranges)))[good])


def _of_range(msg: Range, step: float) -> Array:
    if not msg.min_range <= msg.range <= msg.max_range:
        return np.zeros((0, 3))
    half = msg.field_of_view / 2
    angles = np.append(np.arange(-half, half, max(step, 1e-3)), half)
    return ends_of(np.full(len(angles), msg.range), angles)


__all__ = ["SensorSource"]
