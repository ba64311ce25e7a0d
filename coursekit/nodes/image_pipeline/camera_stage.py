"""A stage of a camera's pipeline: an image with its camera's info comes in, and goes out changed."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from cv_bridge import CvBridge, CvBridgeError
from message_filters import Subscriber, TimeSynchronizer
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import CameraInfo, Image

from coursekit.nodes.nav2.parameters import declare


class CameraStage(Node):
    """Takes image_raw and camera_info of the same stamp under `into`, and publishes both under `out`."""

    def __init__(self, name: str, into: str, out: str, defaults: Mapping[str, Any]) -> None:
        super().__init__(name)
        self.given = declare(self, defaults)
        self._bridge = CvBridge()
        self._image = self.create_publisher(Image, f"{out}/image_raw", 10)
        self._info = self.create_publisher(CameraInfo, f"{out}/camera_info", 10)
        inputs = ((Image, f"{into}/image_raw"), (CameraInfo, f"{into}/camera_info"))
        filters = [Subscriber(self, kind, topic, qos_profile=qos_profile_sensor_data) for kind, topic in inputs]
        self._together = TimeSynchronizer(filters, 10)
        self._together.registerCallback(self._take)

    def change(self, picture: Any, info: CameraInfo) -> Any:
        """Return the changed picture, and change the info, which is a copy."""
        raise NotImplementedError(self.get_name())

    def _take(self, image: Image, info: CameraInfo) -> None:
        if not self._image.get_subscription_count() + self._info.get_subscription_count():
            return
        try:
            picture = self._bridge.imgmsg_to_cv2(image)
        except CvBridgeError as fault:
            self.get_logger().error(f"cv_bridge exception: {fault}")
            return
        changed = self.change(picture, info)
        self._image.publish(self._bridge.cv2_to_imgmsg(changed, image.encoding, header=image.header))
        self._info.publish(info)
