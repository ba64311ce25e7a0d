"""An image pipeline of camera, watermark and view; each writes its process and the message's address on the image."""

from __future__ import annotations

from typing import Any

import cv2
import rclpy
from cv_bridge import CvBridge
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.intra_process.handover import Handover
from coursekit.nodes.running import run, spin_to_the_end, terminate
from coursekit.processes.process import current_process

WIDTH, HEIGHT = 320, 240
_GREEN = (0, 255, 0)
_bridge = CvBridge()


def _sign(image: Any, msg: Image, row: int, more: str = "") -> None:
    """Write the process and the message's memory address on the image."""
    process = current_process()
    text = f"pid: {process.pid if process else 0}, ptr: {id(msg):#x}{more}"
    cv2.putText(image, text, (10, row), cv2.FONT_HERSHEY_SIMPLEX, 0.5, _GREEN)


def _fill(msg: Image, image: Any) -> None:
    """Put an image into a message; the message object and its header stay the same."""
    whole = _bridge.cv2_to_imgmsg(image, "bgr8")
    for field in ("height", "width", "encoding", "is_bigendian", "step", "data"):
        setattr(msg, field, getattr(whole, field))


def _stamp(msg: Image) -> tuple[int, int]:
    return msg.header.stamp.sec, msg.header.stamp.nanosec


class CameraNode(CppNode):
    """Publishes images of the first camera. RuntimeError without one."""

    def __init__(self, handover: Handover | None = None) -> None:
        super().__init__("camera_node")
        self._handover = handover or Handover(_stamp)
        self._camera = cv2.VideoCapture(0)
        self._camera.set(cv2.CAP_PROP_FRAME_WIDTH, WIDTH)
        self._camera.set(cv2.CAP_PROP_FRAME_HEIGHT, HEIGHT)
        if not self._camera.isOpened():
            instead = "ros2 run image_tools cam2image --ros-args -p burger_mode:=true"
            self.get_logger().error(f"Could not open video stream; without a camera `{instead}` publishes images")
            raise RuntimeError("Could not open video stream!")
        self._publisher = self.create_publisher(Image, "image", qos_profile_sensor_data)
        self.create_timer(1 / 30, self._publish)

    def _publish(self) -> None:
        there, image = self._camera.read()
        if not there:
            return
        msg = Image()
        _sign(image, msg, 20)
        _fill(msg, image)
        msg.header.stamp, msg.header.frame_id = self.get_clock().now().to_msg(), "camera_frame"
        self._handover.publish(self._publisher, msg)


class WatermarkNode(CppNode):
    """Republishes images from `image` on `watermarked_image`, with a greeting."""

    def __init__(self, handover: Handover | None = None) -> None:
        super().__init__("watermark_node")
        self._handover = handover or Handover(_stamp)
        self._publisher = self.create_publisher(Image, "watermarked_image", qos_profile_sensor_data)
        self._subscription = self.create_subscription(Image, "image", self._pass_on, qos_profile_sensor_data)

    def _pass_on(self, copy: Image) -> None:
        msg = self._handover.take(self._subscription.topic_name, copy)
        image = _bridge.imgmsg_to_cv2(msg, "bgr8").copy()
        _sign(image, msg, 40, " Hello world!")
        _fill(msg, image)
        self._handover.publish(self._publisher, msg)


class ImageViewNode(CppNode):
    """Shows `watermarked_image` in a window named after the node."""

    def __init__(self, name: str = "image_view_node", handover: Handover | None = None) -> None:
        super().__init__(name)
        self._handover = handover or Handover(_stamp)
        self._subscription = self.create_subscription(Image, "watermarked_image", self._show, qos_profile_sensor_data)

    def _show(self, copy: Image) -> None:
        msg = self._handover.take(self._subscription.topic_name, copy)
        image = _bridge.imgmsg_to_cv2(msg, "bgr8").copy()
        _sign(image, msg, 60)
        cv2.imshow(self.get_name(), image)

    def destroy_node(self) -> None:
        """Close the window and destroy the node."""
        if cv2.getWindowProperty(self.get_name(), cv2.WND_PROP_VISIBLE) > 0:
            cv2.destroyWindow(self.get_name())
        super().destroy_node()


def camera(args: list[str] | None = None) -> int:
    """Run only the camera."""
    return run(CameraNode, args, refuses=(RuntimeError,))


def watermark(args: list[str] | None = None) -> int:
    """Run only the watermark."""
    return run(WatermarkNode, args)


def view(args: list[str] | None = None) -> int:
    """Run only the view."""
    return run(ImageViewNode, args)


def _together(views: list[str], args: list[str] | None) -> int:
    rclpy.init(args=args)
    handover = Handover(_stamp)
    try:
        source = CameraNode(handover)
    except RuntimeError as fault:
        return terminate(str(fault))
    return spin_to_the_end(source, WatermarkNode(handover), *(ImageViewNode(name, handover) for name in views))


def all_in_one(args: list[str] | None = None) -> int:
    """Run all three nodes in one process."""
    return _together(["image_view_node"], args)


def two_views(args: list[str] | None = None) -> int:
    """Run the same pipeline with two views."""
    return _together(["image_view_node", "image_view_node2"], args)
