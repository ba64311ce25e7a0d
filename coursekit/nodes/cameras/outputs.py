"""What a camera publishes: images, the same compressed, and the camera's calibration."""

from __future__ import annotations

from typing import Any

import cv2
from cv_bridge import CvBridge
from rclpy.node import Node
from sensor_msgs.msg import CameraInfo, CompressedImage, Image
from std_msgs.msg import Header

from coursekit.nodes.images.transport import compress

_TURNED = {
    "rgb8": cv2.COLOR_BGR2RGB,
    "rgba8": cv2.COLOR_BGR2RGBA,
    "bgra8": cv2.COLOR_BGR2BGRA,
    "mono8": cv2.COLOR_BGR2GRAY,
    "yuv422": cv2.COLOR_BGR2YUV_UYVY,
    "yuv422_yuy2": cv2.COLOR_BGR2YUV_YUY2,
}
ENCODINGS = ("bgr8", *_TURNED, "mono16")
"""What a picture is published as."""


def encoded(picture: Any, encoding: str) -> Image:
    """Make a message of a picture in BGR order. ValueError for an encoding that is not in ENCODINGS.

    >>> import numpy as np
    >>> encoded(np.zeros((2, 4, 3), np.uint8), "yuv422_yuy2").step
    8
    """
    if encoding not in ENCODINGS:
        raise ValueError(f"'{encoding}' is no encoding of this camera: {', '.join(ENCODINGS)}")
    if encoding == "mono16":
        turned = cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY).astype("uint16") * 257
    else:
        turned = cv2.cvtColor(picture, _TURNED[encoding]) if encoding in _TURNED else picture
    return CvBridge().cv2_to_imgmsg(turned, encoding)


class Outputs:
    """The topics image_raw, image_raw/compressed and camera_info, as image_transport makes them for a camera."""

    def __init__(self, node: Node, depth: int = 10) -> None:
        self._image = node.create_publisher(Image, "image_raw", depth)
        self._compressed = node.create_publisher(CompressedImage, "image_raw/compressed", depth)
        self._info = node.create_publisher(CameraInfo, "camera_info", depth)

    def publish(self, picture: Any, encoding: str, header: Header, info: CameraInfo) -> None:
        """Publish a picture in BGR order and its calibration, under the same header."""
        msg = encoded(picture, encoding)
        msg.header = info.header = header
        self._image.publish(msg)
        if self._compressed.get_subscription_count():
            self._compressed.publish(compress(msg))
        self._info.publish(info)

    def publish_jpeg(self, picture: Any, header: Header, info: CameraInfo) -> None:
        """Publish a picture in BGR order as JPEG alone, and its calibration."""
        data = cv2.imencode(".jpg", picture)[1].tobytes()
        self._compressed.publish(CompressedImage(header=header, format="jpeg", data=data))
        info.header = header
        self._info.publish(info)


def calibration(manager: Any, width: int, height: int) -> CameraInfo:
    """Return a copy of the manager's calibration, or one with the size alone where it is for another size."""
    info = manager.getCameraInfo()
    if (info.width, info.height) != (width, height):
        return CameraInfo(width=width, height=height)
    named = {name: getattr(info, name) for name in CameraInfo.get_fields_and_field_types()}
    return CameraInfo(**named)
