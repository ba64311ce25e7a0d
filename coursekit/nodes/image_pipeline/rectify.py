"""`ros2 run image_proc rectify_node`, also image_proc::RectifyNode: `image` without its distortion as `image_rect`."""

from __future__ import annotations

import cv2
import numpy as np
from cv_bridge import CvBridge
from image_geometry import PinholeCameraModel
from message_filters import Subscriber, TimeSynchronizer
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import CameraInfo, Image

from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.running import run

_DEFAULTS = {"queue_size": 5, "interpolation": 1}


class RectifyNode(Node):
    """Takes images with the camera's info of the same stamp; one without distortion passes as it is."""

    def __init__(self) -> None:
        super().__init__("RectifyNode")
        self._given = declare(self, _DEFAULTS)
        self._bridge, self._model = CvBridge(), PinholeCameraModel()
        self._out = self.create_publisher(Image, "image_rect", 10)
        inputs = ((Image, "image"), (CameraInfo, "camera_info"))
        filters = [Subscriber(self, kind, topic, qos_profile=qos_profile_sensor_data) for kind, topic in inputs]
        self._together = TimeSynchronizer(filters, self._given["queue_size"])
        self._together.registerCallback(self._take)

    def _take(self, image: Image, info: CameraInfo) -> None:
        if self._out.get_subscription_count() == 0:
            return
        if info.k[0] == 0.0:
            self.get_logger().error(
                f"Rectified topic '{self._out.topic_name}' requested but camera publishing"
                f" '{self.resolve_topic_name('camera_info')}' is uncalibrated"
            )
            return
        self._out.publish(self._rectified(image, info) if any(info.d) else image)

    def _rectified(self, image: Image, info: CameraInfo) -> Image:
        self._model.fromCameraInfo(info)
        raw, model = self._bridge.imgmsg_to_cv2(image), self._model
        size = (raw.shape[1], raw.shape[0])
        columns, rows = cv2.initUndistortRectifyMap(
            np.asarray(model.K), np.asarray(model.D), np.asarray(model.R), np.asarray(model.P), size, cv2.CV_32FC1
        )
        rectified = cv2.remap(raw, columns, rows, self._given["interpolation"])
        return self._bridge.cv2_to_imgmsg(rectified, image.encoding, header=image.header)


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(RectifyNode, args)
