"""`ros2 run image_publisher image_publisher_node FILE`: publishes a picture, a film or a camera, again and again."""

from __future__ import annotations

import math
import sys
from typing import Any

import cv2
from camera_info_manager import CameraInfoManager
from rcl_interfaces.msg import SetParametersResult
from rclpy.parameter import Parameter
from rclpy.utilities import remove_ros_args
from sensor_msgs.msg import CameraInfo
from std_msgs.msg import Header

from coursekit.nodes.cameras.device import NoDevice, opened
from coursekit.nodes.cameras.outputs import Outputs
from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.running import run

_DEFAULTS: dict[str, Any] = {
    "field_of_view": 0.0, "flip_horizontal": False, "flip_vertical": False, "frame_id": "camera", "publish_rate": 10.0,
    "camera_info_url": "", "retry": False, "timeout": 2000,
}  # fmt: skip
_READ_AGAIN = {"filename", "field_of_view", "flip_horizontal", "flip_vertical", "retry", "timeout"}
USAGE = (
    "image_publisher requires filename. Typical command-line usage:\n"
    "\t$ ros2 run image_publisher image_publisher_node <filename>"
)


class ImagePublisher(CppNode):
    """Publishes `filename` at `publish_rate`; a film begins again at its end."""

    def __init__(self, filename: str = "") -> None:
        super().__init__("ImagePublisher")
        self._outputs = Outputs(self)
        self._timer: Any = None
        self._still: Any = None
        self._film: Any = None
        self._given = {"filename": self.declare_parameter("filename", filename).value}
        self._given |= {name: self.declare_parameter(name, default).value for name, default in _DEFAULTS.items()}
        self._read()
        self._begin()
        self.add_on_set_parameters_callback(self._change)

    def _change(self, parameters: list[Parameter]) -> SetParametersResult:
        changed = {parameter.name: parameter.value for parameter in parameters if parameter.name in self._given}
        if changed.get("publish_rate", 1.0) <= 0:
            return SetParametersResult(successful=False, reason="publish_rate is images a second, more than 0")
        for name, value in changed.items():
            self.get_logger().info(f"Reset {name} as '{value}'")
        self._given |= changed
        if changed.keys() & _READ_AGAIN:
            self._read()
        if changed.keys() & {"publish_rate", "camera_info_url"}:
            self._begin()
        return SetParametersResult(successful=True)

    def _begin(self) -> None:
        """Publish at the rate that is given now."""
        if self._timer is not None:
            self._timer.destroy()
        self._timer = self.create_timer(1.0 / self._given["publish_rate"], self._publish)
        url = self._given["camera_info_url"]
        if url:
            manager = CameraInfoManager(self, "camera", url)
            manager.loadCameraInfo()
            self._info = manager.getCameraInfo()

    def _read(self) -> None:
        """Open the file, or the camera of that number."""
        name = self._given["filename"]
        self.get_logger().info(f"File name for publishing image is : {name}")
        self._still, self._film = cv2.imread(name), None
        if self._still is None:
            try:
                self._film = opened(name)
            except NoDevice:
                self.get_logger().error(f"Failed to load image ({name}): it is no picture, no film and no camera")
                return
        if not self._given["camera_info_url"]:
            self._info = self._guessed()

    def _guessed(self) -> CameraInfo:
        """A camera without distortion, with the field of view that is given [degrees], or a focal length of 1."""
        if self._still is None:
            sizes = (self._film.get(cv2.CAP_PROP_FRAME_WIDTH), self._film.get(cv2.CAP_PROP_FRAME_HEIGHT))
        else:
            sizes = (self._still.shape[1], self._still.shape[0])
        width, height = map(int, sizes)
        view = math.radians(self._given["field_of_view"])
        focal, x, y = (width // 2) / math.tan(view / 2) if view else 1.0, float(width // 2), float(height // 2)
        return CameraInfo(
            width=width, height=height, distortion_model="plumb_bob", d=[0.0] * 5,
            k=[focal, 0.0, x, 0.0, focal, y, 0.0, 0.0, 1.0], r=[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0],
            p=[focal, 0.0, x, 0.0, 0.0, focal, y, 0.0, 0.0, 0.0, 1.0, 0.0],
        )  # fmt: skip

    def _next(self) -> Any:
        """The picture that is due, or None."""
        if self._film is None:
            return self._still
        seen, picture = self._film.read()
        if not seen:
            self._film.set(cv2.CAP_PROP_POS_FRAMES, 0)
            seen, picture = self._film.read()
        return picture if seen else None

    def _publish(self) -> None:
        if self._still is None and self._film is None and self._given["retry"]:
            self._read()
        picture = self._next()
        if picture is None:
            return
        across, down = self._given["flip_horizontal"], self._given["flip_vertical"]
        if across or down:
            picture = cv2.flip(picture, {(True, True): 0, (True, False): 1, (False, True): -1}[across, down])
        header = Header(stamp=self.get_clock().now().to_msg(), frame_id=self._given["frame_id"])
        self._outputs.publish(picture, "bgr8", header, self._info)


def main(args: list[str] | None = None) -> int:
    """Publish the file of the command line until Ctrl-C."""
    words = sys.argv if args is None else args
    files = remove_ros_args(words)[1:]
    if len(words) < 2:
        print(USAGE, file=sys.stderr)
        return 1
    return run(lambda: ImagePublisher(files[0] if files else ""), args)


def component() -> int:
    """Publish the file in the parameters, as the component in a container does."""
    return run(ImagePublisher, ["component"])
