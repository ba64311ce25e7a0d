"""`ros2 run image_tools showimage`: logs and shows the images received on /image."""

from __future__ import annotations

import cv2
from sensor_msgs.msg import Image

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.images.transport import to_bgr
from coursekit.nodes.running import run

from .options import declared_qos
from .usage import told

_PARAMETERS = {"show_image": "whether a window shows them (true)", "window_name": "its title (the topic's name)"}


class ShowImage(CppNode):
    """Logs the images' frames; shows the images unless `show_image` is false."""

    def __init__(self) -> None:
        super().__init__("showimage")
        self._shows = bool(self.declare_parameter("show_image", True).value)
        self._window = str(self.declare_parameter("window_name", "").value) or self.resolve_topic_name("image")
        self.create_subscription(Image, "image", self._seen, declared_qos(self))

    def destroy_node(self) -> None:
        """Close the window and destroy the node."""
        super().destroy_node()
        if self._shows and cv2.getWindowProperty(self._window, cv2.WND_PROP_VISIBLE) > 0:
            cv2.destroyWindow(self._window)

    def _seen(self, msg: Image) -> None:
        self.get_logger().info(f"Received image #{msg.header.frame_id}")
        if self._shows:
            cv2.imshow(self._window, to_bgr(msg))


def main(args: list[str] | None = None) -> int:
    """Show images until Ctrl-C."""
    if told("showimage", "Shows the images that come on /image.", _PARAMETERS, args):
        return 0
    return run(ShowImage, args, refuses=(ValueError,))
