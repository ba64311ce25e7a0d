"""Convert between maps in memory and nav_msgs/OccupancyGrid."""

from __future__ import annotations

import math
from array import array
from typing import TYPE_CHECKING

import numpy as np
from nav_msgs.msg import OccupancyGrid
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

from coursekit.geometry.rotation import yaw_of
from coursekit.nav.map_file import GridMap

if TYPE_CHECKING:
    from builtin_interfaces.msg import Time as TimeMsg

MAP_QOS = QoSProfile(depth=1, reliability=ReliabilityPolicy.RELIABLE, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def to_message(grid: GridMap, frame: str, stamp: TimeMsg) -> OccupancyGrid:
    """Return a map as a message; its origin's yaw becomes a quaternion."""
    msg = OccupancyGrid()
    msg.header.frame_id = frame
    msg.header.stamp = msg.info.map_load_time = stamp
    msg.info.resolution = grid.resolution
    msg.info.height, msg.info.width = grid.cells.shape
    x, y, yaw = grid.origin
    pose = msg.info.origin
    pose.position.x, pose.position.y = x, y
    pose.orientation.z, pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
    msg.data = array("b", np.ascontiguousarray(grid.cells, np.int8).tobytes())
    return msg


def from_message(msg: OccupancyGrid) -> GridMap:
    """Return a message's map. ValueError if its data are not width x height.

    >>> msg = OccupancyGrid(data=[0, 100])
    >>> msg.info.width, msg.info.height, msg.info.resolution = 2, 1, 0.05
    >>> from_message(msg).cells.tolist()
    [[0, 100]]
    """
    cells = np.array(msg.data, dtype=np.int8).reshape(msg.info.height, msg.info.width)
    pose = msg.info.origin
    q = pose.orientation
    yaw = yaw_of((q.x, q.y, q.z, q.w))
    return GridMap(cells, float(f"{msg.info.resolution:.6g}"), (pose.position.x, pose.position.y, yaw))
