"""`ros2 run image_tools cam2image`: publishes camera images, or images of a burger with burger_mode."""

from __future__ import annotations

from typing import Any

import cv2
from cv_bridge import CvBridge
from sensor_msgs.msg import Image
from std_msgs.msg import Bool

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.running import run

from .burger import Burgers
from .options import declared_qos
from .usage import told

_PARAMETERS = {
    "frequency": "images a second (30)",
    "burger_mode": "whether burgers stand in for a camera (false)",
    "show_camera": "whether a window shows them (false)",
    "device_id": "the number of the camera (0)",
    "width": "pixels (320)",
    "height": "pixels (240)",
    "frame_id": "the frame of the camera (camera_frame)",
}


class Cam2Image(CppNode):
    """Publishes on /image; true on /flip_image mirrors the images. RuntimeError without a camera."""

    def __init__(self) -> None:
        super().__init__("cam2image")
        self._count = 0
        self._flip = False
        qos = declared_qos(self)
        frequency = float(self.declare_parameter("frequency", 30.0).value)
        self._shows = bool(self.declare_parameter("show_camera", False).value)
        self._frame_id = str(self.declare_parameter("frame_id", "camera_frame").value)
        self._next_image = self._source()
        self._publisher = self.create_publisher(Image, "image", qos)
        self.create_subscription(Bool, "flip_image", self._turn, 10)
        self.create_timer(1.0 / frequency, self._publish)

    def _source(self) -> Any:
        width = int(self.declare_parameter("width", 320).value)
        height = int(self.declare_parameter("height", 240).value)
        device = int(self.declare_parameter("device_id", 0).value)
        if self.declare_parameter("burger_mode", False).value:
            return Burgers(width, height).draw
        camera = cv2.VideoCapture(device)
        camera.set(cv2.CAP_PROP_FRAME_WIDTH, width)
        camera.set(cv2.CAP_PROP_FRAME_HEIGHT, height)
        if not camera.isOpened():
            self.get_logger().error("Could not open video stream; without a camera: -p burger_mode:=true")
            raise RuntimeError("Could not open video stream")
        return lambda: camera.read()[1]

    def destroy_node(self) -> None:
        """Close the window and destroy the node."""
        super().destroy_node()
        if self._shows and cv2.getWindowProperty("cam2image", cv2.WND_PROP_VISIBLE) > 0:
            cv2.destroyWindow("cam2image")

    def _turn(self, msg: Bool) -> None:
        self._flip = msg.data
        self.get_logger().info(f"Set flip mode to: {'on' if msg.data else 'off'}")

    def _publish(self) -> None:
        image = self._next_image()
        if image is None:
            return
        if self._flip:
            image = cv2.flip(image, 1)
        if self._shows:
            cv2.imshow("cam2image", image)
        msg = CvBridge().cv2_to_imgmsg(image, "bgr8")
        msg.header.frame_id = self._frame_id
        msg.header.stamp = self.get_clock().now().to_msg()
        self._count += 1
        self.get_logger().info(f"Publishing image #{self._count}")
        self._publisher.publish(msg)


def main(args: list[str] | None = None) -> int:
    """Publish until Ctrl-C."""
    if told("cam2image", "Publishes the images of a camera.", _PARAMETERS, args):
        return 0
    return run(Cam2Image, args, refuses=(RuntimeError, ValueError))
