"""`ros2 run pointcloud_to_laserscan pointcloud_to_laserscan_node` and `laserscan_to_pointcloud_node`."""

from __future__ import annotations

import math
import os
import sys
from typing import Any

import numpy as np
from laser_geometry import LaserProjection
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from rclpy.time import Time
from sensor_msgs.msg import LaserScan, PointCloud2
from sensor_msgs_py.point_cloud2 import read_points
from tf2_ros import Buffer, TransformException, TransformListener
from tf2_sensor_msgs.tf2_sensor_msgs import do_transform_cloud

from coursekit.nav.scans.making import Fan, floats, of_points
from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.pointcloud_to_laserscan.lazy import LazySubscription
from coursekit.nodes.running import run

_FRAME: dict[str, Any] = {"target_frame": "", "transform_tolerance": 0.01, "queue_size": os.cpu_count() or 1}
_SCAN: dict[str, Any] = {
    "min_height": sys.float_info.min, "max_height": sys.float_info.max, "angle_min": -math.pi, "angle_max": math.pi,
    "angle_increment": math.pi / 180, "scan_time": 1.0 / 30.0, "range_min": 0.0, "range_max": sys.float_info.max,
    "inf_epsilon": 1.0, "use_inf": True,
}  # fmt: skip
_FAN = ("angle_min", "angle_max", "angle_increment", "range_min", "range_max", "min_height", "max_height")
_LARGEST = float(np.finfo(np.float32).max)


class Converter(Node):
    """Subscribes to one type of message while its output of the other has subscribers; both may be in different frames."""

    def __init__(
        self, name: str, given: dict[str, Any], kinds: tuple[Any, Any], topics: tuple[str, str], names: tuple[str, str]
    ) -> None:
        super().__init__(name)
        self.given = declare(self, _FRAME | given)
        self._frame = self.given["target_frame"]
        self._buffer = Buffer(node=self)
        self._listener = TransformListener(self._buffer, self)
        self._out = self.create_publisher(kinds[1], topics[1], qos_profile_sensor_data)
        self._ear = LazySubscription(self, self._out, kinds[0], topics[0], self._hear, self.given["queue_size"])
        published, heard = names
        start, end = f"starting {heard} subscriber", f"shutting down {heard} subscriber"
        self._ear.words = (f"Got a subscriber to {published}, {start}", f"No subscribers to {published}, {end}")

    def _hear(self, msg: Any) -> None:
        raise NotImplementedError

    def moved(self, cloud: PointCloud2) -> PointCloud2 | None:
        """A cloud in the target frame; None, with an error in the log, if its transform is missing."""
        if not self._frame or self._frame == cloud.header.frame_id:
            return cloud
        stamp, wait = Time.from_msg(cloud.header.stamp), Duration(seconds=self.given["transform_tolerance"])
        try:
            transform = self._buffer.lookup_transform(self._frame, cloud.header.frame_id, stamp, wait)
        except TransformException as fault:
            self.get_logger().error(f"Transform failure: {fault}", throttle_duration_sec=1.0)
            return None
        transformed: PointCloud2 = do_transform_cloud(cloud, transform)
        transformed.header.frame_id = self._frame
        return transformed


class PointCloudToLaserScan(Converter):
    """The nearest point of a cloud in each beam, between two heights."""

    def __init__(self) -> None:
        super().__init__("pointcloud_to_laserscan", _SCAN, (PointCloud2, LaserScan), ("cloud_in", "scan"),
                         ("laserscan", "pointcloud"))  # fmt: skip
        self._fan = Fan(*(self.given[name] for name in _FAN))

    def _hear(self, msg: PointCloud2) -> None:
        cloud = self.moved(msg)
        if cloud is None:
            return
        scan, fan, given = LaserScan(), self._fan, self.given
        scan.header.stamp, scan.header.frame_id = msg.header.stamp, cloud.header.frame_id
        for name in ("angle_min", "angle_max", "angle_increment", "range_min"):
            setattr(scan, name, getattr(fan, name))
        scan.scan_time, scan.range_max = given["scan_time"], min(fan.range_max, _LARGEST)
        nothing = math.inf if given["use_inf"] else min(fan.range_max + given["inf_epsilon"], _LARGEST)
        table = read_points(cloud, field_names=["x", "y", "z"], skip_nans=True)
        points = np.column_stack([np.asarray(table[axis], float).ravel() for axis in "xyz"])
        scan.ranges = floats(of_points(points, fan, nothing))
        self._out.publish(scan)


class LaserScanToPointCloud(Converter):
    """The points at which a scan's beams end."""

    def __init__(self) -> None:
        super().__init__("laserscan_to_pointcloud", {}, (LaserScan, PointCloud2), ("scan_in", "cloud"),
                         ("pointcloud", "laserscan"))  # fmt: skip
        self._projection = LaserProjection()

    def _hear(self, msg: LaserScan) -> None:
        cloud = self.moved(self._projection.projectLaser(msg))
        if cloud is not None:
            self._out.publish(cloud)


def to_scan(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(PointCloudToLaserScan, args)


def to_cloud(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(LaserScanToPointCloud, args)
