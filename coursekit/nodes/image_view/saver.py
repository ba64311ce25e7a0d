"""`ros2 run image_view image_saver --ros-args -r image:=TOPIC`: writes images, and their camera's calibration, to files."""

from __future__ import annotations

from typing import Any

from cv_bridge import CvBridge, CvBridgeError
from message_filters import Subscriber, TimeSynchronizer
from rclpy.node import Node
from rclpy.time import Time
from sensor_msgs.msg import CameraInfo, Image
from std_srvs.srv import Empty, Trigger

from coursekit.files import write_whole
from coursekit.nodes.running import run
from coursekit.processes.current_process import program_folder

from .picture_file import name_of, save

_DEFAULTS = {
    "filename_format": "left%04i.%s", "encoding": "bgr8", "save_all_image": True, "stamped_filename": False,
    "request_start_end": False,
}  # fmt: skip
_MATRICES = (("camera matrix", "k", 3), ("distortion", "d", 5), ("rectification", "r", 3), ("projection", "p", 4))


class ImageSaverNode(Node):
    """Saves every image; with save_all_image false only those that `save` asks for."""

    def __init__(self) -> None:
        super().__init__("image_saver_node")
        self._given: dict[str, Any] = {n: self.declare_parameter(n, default).value for n, default in _DEFAULTS.items()}
        self._bridge, self._count, self._asked = CvBridge(), 0, False
        self._begin: Time | None = None
        self._end: Time | None = None
        topic = self.resolve_topic_name("image")
        self._info = f"{topic.rpartition('/')[0]}/camera_info"
        self.create_subscription(Image, topic, self._alone, 10)
        filters = [Subscriber(self, kind, name, qos_profile=10) for kind, name in ((Image, topic), (CameraInfo, self._info))]
        self._together = TimeSynchronizer(filters, 10)
        self._together.registerCallback(self._save)
        self.create_service(Empty, "save", self._once)
        self.create_service(Trigger, "start", self._started)
        self.create_service(Trigger, "end", self._ended)

    def _once(self, _request: Any, response: Any) -> Any:
        self._asked = True
        return response

    def _started(self, _request: Any, response: Any) -> Any:
        self.get_logger().info("Received start saving request")
        self._begin, self._end = self.get_clock().now(), None
        response.success = True
        return response

    def _ended(self, _request: Any, response: Any) -> Any:
        self.get_logger().info("Received end saving request")
        self._end = self.get_clock().now()
        response.success = True
        return response

    def _alone(self, image: Image) -> None:
        """Save an image whose camera tells nothing of itself; others come with its info."""
        if not self.count_publishers(self._info):
            self._save(image, None)

    def _save(self, image: Image, info: CameraInfo | None) -> None:
        if not self._wanted(image):
            return
        try:
            picture = self._bridge.imgmsg_to_cv2(image, self._given["encoding"])
        except CvBridgeError:
            self.get_logger().error(f"Unable to convert {image.encoding} image to {self._given['encoding']}")
            return
        name = name_of(self._given["filename_format"], self._count)
        if self._given["stamped_filename"]:
            name = f"{self.get_clock().now().nanoseconds}{name}"
        self._asked = False
        if save(self, name, picture) and info is not None:
            write_whole((program_folder() / name).with_suffix(".ini"), calibration(info))
        self._count += 1

    def _wanted(self, image: Image) -> bool:
        if self._asked:
            return True
        if self._given["request_start_end"]:
            stamp = Time.from_msg(image.header.stamp)
            begun = self._begin is not None and self._begin <= stamp
            if not begun or (self._end is not None and self._end < stamp):
                return False
        return bool(self._given["save_all_image"])


def calibration(info: CameraInfo, camera: str = "camera") -> str:
    """Return a calibration as text, in the form of .ini files of camera_calibration_parsers."""
    text = f"# Camera intrinsics\n\n[image]\n\nwidth\n{info.width}\n\nheight\n{info.height}\n\n[{camera}]\n"
    for title, field, columns in _MATRICES:
        values = [f"{float(number):.5f}" for number in getattr(info, field)]
        rows = [" ".join(values[k : k + columns]) for k in range(0, len(values), columns)]
        text += "\n" + "\n".join([title, *rows]) + "\n"
    return text


def main(args: list[str] | None = None) -> int:
    """Save until Ctrl-C."""
    return run(ImageSaverNode, args)
