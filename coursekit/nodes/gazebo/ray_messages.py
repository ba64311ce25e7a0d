"""The messages of a ray sensor: the four types of gazebo_ros_ray_sensor."""

from __future__ import annotations

import math
from array import array
from collections.abc import Callable
from typing import Any

import numpy as np
from geometry_msgs.msg import Point32
from sensor_msgs.msg import ChannelFloat32, LaserScan, PointCloud, PointCloud2, PointField, Range

from coursekit.geometry.plane import Array

from .devices import RayDevice

LASER, CLOUD = "sensor_msgs/LaserScan", "sensor_msgs/PointCloud2"


def laser_scan(device: RayDevice, ranges: Array) -> LaserScan:
    """Return distances in the order of the beams; inf without an echo."""
    lidar = device.lidar
    msg = LaserScan(range_min=lidar.range_min, range_max=lidar.range_max)
    msg.angle_min, msg.angle_max, msg.angle_increment = lidar.angle_min, lidar.angle_max, lidar.step
    msg.ranges = array("f", ranges.astype(np.float32).tobytes())
    msg.intensities = array("f", bytes(4 * lidar.beams))
    return msg


def _points(device: RayDevice, ranges: Array) -> Array:
    """Return the ends of the beams in the sensor's frame (n, 3)."""
    lidar = device.lidar
    angles = lidar.angle_min + lidar.step * np.arange(lidar.beams)
    hit = np.isfinite(ranges)
    return np.column_stack((np.cos(angles), np.sin(angles), np.zeros(lidar.beams)))[hit] * ranges[hit, None]


def point_cloud2(device: RayDevice, ranges: Array) -> PointCloud2:
    """Return points with x, y, z and intensity, each a float32."""
    points = _points(device, ranges)
    rows = np.zeros((len(points), 4), np.float32)
    rows[:, :3] = points
    msg = PointCloud2(height=1, width=len(rows), point_step=16, row_step=16 * len(rows), is_dense=True)
    names = ("x", "y", "z", "intensity")
    msg.fields = [PointField(name=name, offset=4 * k, datatype=PointField.FLOAT32, count=1) for k, name in enumerate(names)]
    msg.data = rows.tobytes()
    return msg


def point_cloud(device: RayDevice, ranges: Array) -> PointCloud:
    """Return the older type of cloud."""
    points = [Point32(x=float(x), y=float(y), z=float(z)) for x, y, z in _points(device, ranges)]
    return PointCloud(points=points, channels=[ChannelFloat32(name="intensity", values=[0.0] * len(points))])


def range_of(device: RayDevice, ranges: Array) -> Range:
    """Return the nearest distance in the cone."""
    lidar = device.lidar
    seen = ranges[ranges > 0.0]
    msg = Range(radiation_type=device.radiation, min_range=lidar.range_min, max_range=lidar.range_max)
    msg.field_of_view = abs(lidar.angle_max - lidar.angle_min)
    msg.range = float(seen.min()) if len(seen) else math.inf
    return msg


RAY_TYPES: dict[str, tuple[type, Callable[[RayDevice, Array], Any]]] = {
    LASER: (LaserScan, laser_scan), CLOUD: (PointCloud2, point_cloud2), "sensor_msgs/PointCloud": (PointCloud, point_cloud),
    "sensor_msgs/Range": (Range, range_of),
}  # fmt: skip
__all__ = ["CLOUD", "LASER", "RAY_TYPES"]
