"""`ros2 run image_proc debayer_node`, also image_proc::DebayerNode: image_raw as image_color and image_mono."""

from __future__ import annotations

from typing import Any

from cv_bridge import CvBridge, CvBridgeError
from cv_bridge.encodings import parse
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image

from coursekit.nodes.running import run


class DebayerNode(Node):
    """Makes colours of a sensor's mosaic, and grey of colours; what has them already passes as it is."""

    def __init__(self) -> None:
        super().__init__("DebayerNode")
        self.declare_parameter("debayer", 3)
        self._bridge = CvBridge()
        self._mono = self.create_publisher(Image, "image_mono", 10)
        self._color = self.create_publisher(Image, "image_color", 10)
        self._raw = self.create_subscription(Image, "image_raw", self._take, qos_profile_sensor_data)

    def _take(self, image: Image) -> None:
        encoding = parse(image.encoding)
        is_mono = image.encoding.startswith("mono")
        bits = 16 if encoding.bits == 16 else 8
        if self._mono.get_subscription_count():
            self._send(self._mono, image, "" if is_mono else f"mono{bits}")
        if not self._color.get_subscription_count():
            return
        if is_mono:
            self.get_logger().warning(
                f"Color topic '{self._color.topic_name}' requested, but raw image data from topic "
                f"'{self._raw.topic_name}' is grayscale"
            )
        has_colours = is_mono or encoding.kind in ("bgr", "rgb", "bgra", "rgba")
        self._send(self._color, image, "" if has_colours else f"bgr{bits}")

    def _send(self, publisher: Any, image: Image, encoding: str) -> None:
        """Publish an image in an encoding, or as it is."""
        try:
            picture = self._bridge.imgmsg_to_cv2(image, encoding) if encoding else None
        except CvBridgeError as fault:
            self.get_logger().warning(f"cv_bridge conversion error: '{fault}'")
            return
        publisher.publish(image if picture is None else self._bridge.cv2_to_imgmsg(picture, encoding, header=image.header))


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(DebayerNode, args)
