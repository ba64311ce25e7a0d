"""`ros2 run image_view image_view --ros-args -r image:=TOPIC`: shows an image topic in a window."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
from cv_bridge import CvBridge, CvBridgeError
from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter
from sensor_msgs.msg import Image

from coursekit.nodes.images.transport import TRANSPORTS, to_bgr, topic_of
from coursekit.nodes.running import run

from .picture_file import name_of, save

_DEFAULTS = {
    "image_transport": "raw", "gui": True, "autosize": False, "height": -1, "width": -1, "colormap": -1,
    "filename_format": "frame%04i.jpg", "min_image_value": 0, "max_image_value": 0,
}  # fmt: skip
_FURTHEST = {"32FC1": 10.0, "16UC1": 10_000.0}
"""What is white in an image of depths, if nobody says it: 10 m."""


class ImageViewNode(Node):
    """Shows images and passes them on as `output`; the right button saves the one that is shown."""

    def __init__(self) -> None:
        super().__init__("image_view_node")
        topic = self.resolve_topic_name("image")
        self._given: dict[str, Any] = {n: self.declare_parameter(n, default).value for n, default in _DEFAULTS.items()}
        self._window = str(self.declare_parameter("window_name", topic).value)
        self._count, self._warned = 0, False
        self.get_logger().info(f'Using transport "{self._given["image_transport"]}"')
        if topic == self.resolve_topic_name("image", only_expand=True):
            usage = "\t$ ros2 run image_view image_view --ros-args -r image:=<image topic>"
            self.get_logger().warning(f"Topic 'image' has not been remapped! Typical command-line usage:\n{usage}")
        self._out = self.create_publisher(Image, "output", 1)
        transport = self._given["image_transport"]
        self.create_subscription(TRANSPORTS.get(transport, Image), topic_of(topic, transport), self._take, 10)
        self.add_on_set_parameters_callback(self._asked)
        if self._given["gui"]:
            cv2.namedWindow(self._window)
            cv2.setMouseCallback(self._window, self._mouse)
            self.create_timer(0.1, cv2.pollKey)
        self._shown: Any = None

    def destroy_node(self) -> None:
        """Close the window and destroy the node."""
        super().destroy_node()
        if self._given["gui"] and cv2.getWindowProperty(self._window, cv2.WND_PROP_VISIBLE) > 0:
            cv2.destroyWindow(self._window)

    def _asked(self, parameters: list[Parameter]) -> SetParametersResult:
        self._given |= {parameter.name: parameter.value for parameter in parameters if parameter.name in _DEFAULTS}
        return SetParametersResult(successful=True)

    def _take(self, msg: Any) -> None:
        if self._given["gui"]:
            try:
                self._shown = self._picture(msg)
                cv2.imshow(self._window, self._shown)
            except (CvBridgeError, cv2.error) as fault:
                encoding = getattr(msg, "encoding", "compressed")
                text = f"Unable to convert '{encoding}' image for display: '{fault}'"
                self.get_logger().error(text, throttle_duration_sec=30.0)
        if isinstance(msg, Image) and self._out.get_subscription_count() > 0:
            self._out.publish(msg)

    def _picture(self, msg: Any) -> Any:
        """The image in colours; depths by their distance, other numbers from the least to the most."""
        encoding = getattr(msg, "encoding", "")
        if encoding not in _FURTHEST:
            return to_bgr(msg)
        depths = CvBridge().imgmsg_to_cv2(msg).astype(np.float64)
        least, most = float(self._given["min_image_value"]), float(self._given["max_image_value"])
        if "F" in encoding:
            finite = depths[np.isfinite(depths)]
            least, most = (finite.min(), finite.max()) if finite.size else (0.0, 1.0)
        elif least == most:
            least, most = 0.0, _FURTHEST[encoding]
        grey = np.nan_to_num(np.clip((depths - least) * (255.0 / ((most - least) or 1.0)), 0, 255)).astype(np.uint8)
        if self._given["colormap"] >= 0:
            return cv2.applyColorMap(grey, self._given["colormap"])
        return cv2.cvtColor(grey, cv2.COLOR_GRAY2BGR)

    def _mouse(self, event: int, _x: int, _y: int, _flags: int, _param: Any) -> None:
        if event == cv2.EVENT_LBUTTONDOWN and not self._warned:
            self._warned = True
            self.get_logger().warning("Left-clicking no longer saves images. Right-click instead.")
        if event != cv2.EVENT_RBUTTONDOWN:
            return
        if self._shown is None:
            self.get_logger().warning("Couldn't save image, no data!")
        elif save(self, name_of(self._given["filename_format"], self._count), self._shown):
            self._count += 1


def main(args: list[str] | None = None) -> int:
    """Show until Ctrl-C."""
    return run(ImageViewNode, args, refuses=(ValueError,))
