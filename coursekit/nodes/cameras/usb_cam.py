"""`ros2 run usb_cam usb_cam_node_exe`, also usb_cam::UsbCamNode: publishes what a camera of Linux shows."""

from __future__ import annotations

from typing import Any

import cv2
from camera_info_manager import CameraInfoManager
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import Header
from std_srvs.srv import SetBool

from coursekit.nodes.cameras.device import NoDevice, opened, resize
from coursekit.nodes.cameras.outputs import Outputs, calibration
from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.running import run

_DEFAULTS: dict[str, Any] = {
    "camera_name": "default_cam", "camera_info_url": "", "framerate": 30.0, "frame_id": "default_cam",
    "image_height": 480, "image_width": 640, "io_method": "mmap", "pixel_format": "yuyv",
    "av_device_format": "YUV422P", "video_device": "/dev/video0", "brightness": 50, "contrast": -1, "saturation": -1,
    "sharpness": -1, "gain": -1, "auto_white_balance": True, "white_balance": 4000, "autoexposure": True,
    "exposure": 100, "autofocus": False, "focus": -1,
}  # fmt: skip
_FORMATS = {
    "rgb8": "rgb8", "yuyv": "yuv422_yuy2", "yuyv2rgb": "rgb8", "uyvy": "yuv422", "uyvy2rgb": "rgb8", "mono8": "mono8",
    "mono16": "mono16", "y102mono8": "mono8", "mjpeg2rgb": "rgb8", "m4202rgb": "rgb8", "mjpeg": "",
}  # fmt: skip
"""The encoding on image_raw by `pixel_format`; mjpeg comes as image_raw/compressed alone."""
_CONTROLS = {
    "brightness": cv2.CAP_PROP_BRIGHTNESS, "contrast": cv2.CAP_PROP_CONTRAST, "saturation": cv2.CAP_PROP_SATURATION,
    "sharpness": cv2.CAP_PROP_SHARPNESS, "gain": cv2.CAP_PROP_GAIN, "focus": cv2.CAP_PROP_FOCUS,
}  # fmt: skip
"""What is left alone at -1."""


class UsbCam(CppNode):
    """Publishes at `framerate` until set_capture says false. ValueError for parameters that no camera has.

    ExternalShutdownException where there is no such camera.
    """

    def __init__(self) -> None:
        super().__init__("usb_cam")
        self.given = given = declare(self, _DEFAULTS)
        if given["pixel_format"] not in _FORMATS:
            raise ValueError(f"Specified format `{given['pixel_format']}` is unsupported: give {', '.join(_FORMATS)}")
        if not given["framerate"] > 0:
            raise ValueError(f"framerate is {given['framerate']}: give images a second, for example 30.0")
        try:
            self._camera = opened(given["video_device"])
        except NoDevice as missing:
            self.get_logger().error(f"Device specified is not available or is not a vaild V4L2 device: `{missing}`")
            raise ExternalShutdownException() from None  # as Humble's, which shuts rclcpp down
        self._start()

    def _start(self) -> None:
        given = self.given
        self.get_logger().info(
            "Starting '{camera_name}' ({video_device}) at {image_width}x{image_height} via {io_method} ({pixel_format}) at "
            "{framerate:.0f} FPS".format(**given)
        )
        self._outputs = Outputs(self, 100)
        self._info = CameraInfoManager(self, given["camera_name"], given["camera_info_url"])
        self._info.loadCameraInfo()
        resize(self._camera, given["image_width"], given["image_height"])
        self._camera.set(cv2.CAP_PROP_FPS, given["framerate"])
        self._set_controls()
        self._capturing = True
        self.create_service(SetBool, "set_capture", self._switch)
        self.create_timer(1.0 / given["framerate"], self._publish)

    def _set_controls(self) -> None:
        """Send brightness and the like to the camera."""
        given = self.given
        wanted = {_CONTROLS[name]: given[name] for name in _CONTROLS if given[name] >= 0}
        wanted[cv2.CAP_PROP_AUTO_WB] = int(given["auto_white_balance"])
        if not given["auto_white_balance"]:
            wanted[cv2.CAP_PROP_WB_TEMPERATURE] = given["white_balance"]
        wanted[cv2.CAP_PROP_AUTO_EXPOSURE] = 3 if given["autoexposure"] else 1  # as V4L2 counts: 1 is by hand
        if not given["autoexposure"]:
            wanted[cv2.CAP_PROP_EXPOSURE] = given["exposure"]
        wanted[cv2.CAP_PROP_AUTOFOCUS] = int(given["autofocus"])
        for control, value in wanted.items():
            self._camera.set(control, value)

    def _switch(self, request: SetBool.Request, response: SetBool.Response) -> SetBool.Response:
        self._capturing = request.data
        response.message = "Start Capturing" if request.data else "Stop Capturing"
        return response

    def _publish(self) -> None:
        if not self._capturing:
            return
        seen, picture = self._camera.read()
        if not seen:
            return
        header = Header(stamp=self.get_clock().now().to_msg(), frame_id=self.given["frame_id"])
        info = calibration(self._info, picture.shape[1], picture.shape[0])
        encoding = _FORMATS[self.given["pixel_format"]]
        if encoding:
            self._outputs.publish(picture, encoding, header, info)
        else:
            self._outputs.publish_jpeg(picture, header, info)


def main(args: list[str] | None = None) -> int:
    """Publish until Ctrl-C."""
    return run(UsbCam, args, refuses=(ValueError,))
