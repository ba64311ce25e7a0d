"""`ros2 run v4l2_camera v4l2_camera_node`, also v4l2_camera::V4L2Camera: publishes what a camera of Linux shows."""

from __future__ import annotations

from typing import Any

import cv2
from camera_info_manager import CameraInfoManager
from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult
from rclpy.parameter import Parameter
from std_msgs.msg import Header

from coursekit.nodes.cameras.device import NoDevice, opened, resize
from coursekit.nodes.cameras.outputs import ENCODINGS, Outputs, calibration
from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.running import run


class V4L2Camera(CppNode):
    """Publishes at the camera's rate. Without a camera it says so and publishes nothing."""

    def __init__(self) -> None:
        super().__init__("v4l2_camera")
        self._outputs = Outputs(self)
        self._timer: Any = None
        device = self._fixed("video_device", "/dev/video0", "Path to video device")
        try:
            self._camera = opened(device)
        except NoDevice:
            self.get_logger().error(f"Failed opening device {device}: No such file or directory (2)")
            return
        self._frame = self._fixed("camera_frame_id", "camera", "Frame id inserted in published image")
        self._info = CameraInfoManager(self, "virtual_camera")
        self.declare_parameter("pixel_format", "YUYV")
        rate = round(self._camera.get(cv2.CAP_PROP_FPS)) or 30
        for name, default in (("output_encoding", "rgb8"), ("camera_info_url", ""), ("image_size", [640, 480]),
                              ("time_per_frame", [1, rate])):  # fmt: skip
            fault = self._take(name, self.declare_parameter(name, default).value)
            if fault:
                self.get_logger().warning(fault)
        self.add_on_set_parameters_callback(self._change)

    def _fixed(self, name: str, default: str, about: str) -> str:
        """The value of a parameter that cannot be set later."""
        return str(self.declare_parameter(name, default, ParameterDescriptor(description=about, read_only=True)).value)

    def _change(self, parameters: list[Parameter]) -> SetParametersResult:
        faults = [fault for parameter in parameters if (fault := self._take(parameter.name, parameter.value))]
        return SetParametersResult(successful=not faults, reason="; ".join(faults))

    def _take(self, name: str, value: Any) -> str:
        """Take a parameter's value, and return what is wrong with it."""
        take = getattr(self, f"_take_{name}", None)
        return str(take(value) or "") if take else ""

    def _take_output_encoding(self, name: str) -> str:
        if name not in ENCODINGS:
            return f"output_encoding is '{name}': give one of {', '.join(ENCODINGS)}"
        self._encoding = name
        return ""

    def _take_camera_info_url(self, url: str) -> str:
        if not self._info.setURL(url):
            return f"Invalid camera info URL: {url}"
        self._info.loadCameraInfo()
        return ""

    def _take_image_size(self, size: Any) -> str:
        if len(size) != 2:
            return f"Invalid image size; expected dimensions: 2, actual: {len(size)}"
        given = resize(self._camera, *size)
        if given != tuple(size):
            self.get_logger().warning(f"The camera has no size of {size[0]}x{size[1]}: it stays at {given[0]}x{given[1]}")
        return ""

    def _take_time_per_frame(self, time: Any) -> str:
        if len(time) != 2 or min(time) <= 0:
            return f"time_per_frame is {list(time)}: give seconds and images, for example [1, 30]"
        self._camera.set(cv2.CAP_PROP_FPS, time[1] / time[0])
        rate = self._camera.get(cv2.CAP_PROP_FPS) or time[1] / time[0]
        if self._timer is not None:
            self._timer.destroy()
        self._timer = self.create_timer(1.0 / rate, self._publish)
        return ""

    def _publish(self) -> None:
        seen, picture = self._camera.read()
        if seen:
            header = Header(stamp=self.get_clock().now().to_msg(), frame_id=self._frame)
            height, width = picture.shape[:2]
            self._outputs.publish(picture, self._encoding, header, calibration(self._info, width, height))


def main(args: list[str] | None = None) -> int:
    """Publish until Ctrl-C."""
    return run(V4L2Camera, args)
