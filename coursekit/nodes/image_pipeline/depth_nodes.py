"""`ros2 run depth_image_proc point_cloud_xyz_node` and `point_cloud_xyzrgb_node`, also as components: clouds on `points`."""

from __future__ import annotations

from typing import Any

import numpy as np
from cv_bridge import CvBridge, CvBridgeError
from message_filters import ApproximateTimeSynchronizer, Subscriber, TimeSynchronizer
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import CameraInfo, Image, PointCloud2

from coursekit.nodes.image_pipeline.clouds import cloud_of
from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.running import run

SLOP_SECONDS = 0.1


def _hear(node: Node, *inputs: tuple[Any, str]) -> list[Subscriber]:
    return [Subscriber(node, kind, topic, qos_profile=qos_profile_sensor_data) for kind, topic in inputs]


class PointCloudXyzNode(Node):
    """`image_rect`, a depth image, and `camera_info` of the same stamp in, `points` out."""

    def __init__(self) -> None:
        super().__init__("PointCloudXyzNode")
        given = declare(self, {"queue_size": 5})
        self._out = self.create_publisher(PointCloud2, "points", qos_profile_sensor_data)
        filters = _hear(self, (Image, "image_rect"), (CameraInfo, "camera_info"))
        self._together = TimeSynchronizer(filters, given["queue_size"])
        self._together.registerCallback(self._take)

    def _take(self, depth: Image, info: CameraInfo) -> None:
        try:
            self._out.publish(cloud_of(depth, info))
        except ValueError as fault:
            self.get_logger().error(str(fault))


class PointCloudXyzrgbNode(Node):
    """`depth_registered/image_rect`, `rgb/image_rect_color` and `rgb/camera_info` in, colored `points` out."""

    def __init__(self) -> None:
        super().__init__("PointCloudXyzrgbNode")
        given = declare(self, {"queue_size": 5, "exact_sync": False, "depth_image_transport": "raw"})
        self._bridge = CvBridge()
        self._out = self.create_publisher(PointCloud2, "points", qos_profile_sensor_data)
        topics = (Image, "depth_registered/image_rect"), (Image, "rgb/image_rect_color"), (CameraInfo, "rgb/camera_info")
        filters, size = _hear(self, *topics), given["queue_size"]
        self._together = (
            TimeSynchronizer(filters, size)
            if given["exact_sync"]
            else ApproximateTimeSynchronizer(filters, size, SLOP_SECONDS)
        )
        self._together.registerCallback(self._take)

    def _take(self, depth: Image, picture: Image, info: CameraInfo) -> None:
        log, frames = self.get_logger(), (depth.header.frame_id, picture.header.frame_id)
        if frames[0] != frames[1]:
            log.warning(
                f"Depth image frame id [{frames[0]}] doesn't match RGB image frame id [{frames[1]}]",
                throttle_duration_sec=10.0,
            )
        if (depth.width, depth.height) != (picture.width, picture.height):
            log.error(
                f"Depth resolution ({depth.width}x{depth.height}) does not match RGB resolution"
                f" ({picture.width}x{picture.height})"
            )
            return
        try:
            self._out.publish(cloud_of(depth, info, np.asarray(self._bridge.imgmsg_to_cv2(picture, "rgb8"))))
        except CvBridgeError as fault:
            log.error(f"Unsupported encoding [{picture.encoding}]: {fault}")
        except ValueError as fault:
            log.error(str(fault))


def xyz(args: list[str] | None = None) -> int:
    """Run the node for clouds without colors until Ctrl-C."""
    return run(PointCloudXyzNode, args)


def xyzrgb(args: list[str] | None = None) -> int:
    """Run the node for colored clouds until Ctrl-C."""
    return run(PointCloudXyzrgbNode, args)
