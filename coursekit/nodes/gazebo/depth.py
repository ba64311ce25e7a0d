"""Simulated depth cameras."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from sensor_msgs.msg import CameraInfo, Image, PointCloud2, PointField

from coursekit.sim.view import Picture

from .cameras import CameraPublisher
from .devices import DepthDevice
from .sensor_publishers import SENSOR, pose_at, stamp_of

FIELDS = (("x", 0), ("y", 4), ("z", 8), ("rgb", 16))
POINT = 32
"""The size of a point with Gazebo's padding [bytes]."""


class DepthPublisher(CameraPublisher):
    """Publishes a camera's images, depths and points; each only if it has subscribers."""

    device: DepthDevice

    def open(self) -> None:
        super().open()
        self._depth = self.publisher(Image, self.device.depth_topic, SENSOR)
        self._depth_info = self.publisher(CameraInfo, self.device.depth_info_topic, SENSOR)
        self._cloud = self.publisher(PointCloud2, self.device.cloud_topic, SENSOR)

    def publish(self, time_ns: int) -> None:
        super().publish(time_ns)
        if self._depth_info.get_subscription_count():
            self._depth_info.publish(self._calibration(time_ns))
        if not (self._depth.get_subscription_count() or self._cloud.get_subscription_count()):
            return
        place = pose_at(self.simulation, self.robot, time_ns)
        depths = self._view.depths(self.simulation, place, without=self.robot)
        near, far = self.device.reach
        depths[~((depths > near) & (depths < far))] = np.nan
        self._publish_depths(depths, time_ns)
        if self._cloud.get_subscription_count():
            self._publish_cloud(depths, self._view.render(self.simulation, place, without=self.robot), time_ns)

    def _publish_depths(self, depths: NDArray[np.float32], time_ns: int) -> None:
        height, width = depths.shape
        msg = Image(height=height, width=width, encoding="32FC1", step=4 * width)
        msg.header.stamp, msg.header.frame_id = stamp_of(time_ns), self.device.frame
        msg.data = depths.tobytes()
        self._depth.publish(msg)

    def _publish_cloud(self, depths: NDArray[np.float32], picture: Picture, time_ns: int) -> None:
        """Publish the points in the optical frame: x to the right, y down, z forward."""
        height, width = depths.shape
        columns, rows = (np.arange(size) - (size - 1) / 2 for size in (width, height))
        points = np.zeros((height, width, POINT // 4), np.float32)
        points[:, :, 0] = depths * columns / self._view.focal
        points[:, :, 1] = depths * rows[:, None] / self._view.focal
        points[:, :, 2] = depths
        points.view(np.uint8).reshape(height, width, POINT)[:, :, 16:19] = picture
        msg = PointCloud2(height=height, width=width, point_step=POINT, row_step=POINT * width, is_dense=False)
        msg.header.stamp, msg.header.frame_id = stamp_of(time_ns), self.device.frame
        msg.fields = [PointField(name=name, offset=at, datatype=PointField.FLOAT32, count=1) for name, at in FIELDS]
        msg.data = points.tobytes()
        self._cloud.publish(msg)


__all__ = ["DepthPublisher"]
