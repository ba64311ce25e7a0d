"""Simulated cameras."""

from __future__ import annotations

import cv2
import numpy as np
from sensor_msgs.msg import CameraInfo, Image

from coursekit.sim.view import Picture, View

from .devices import CameraDevice
from .sensor_publishers import SENSOR, SensorPublisher, pose_at, stamp_of


class CameraPublisher(SensorPublisher):
    """A simulated camera: rgb8 images and their calibration, drawn only for subscribers."""

    device: CameraDevice

    def open(self) -> None:
        device = self.device
        self._image = self.publisher(Image, device.topic, SENSOR)
        self._info = self.publisher(CameraInfo, device.info_topic, SENSOR)
        self._view = view_of(device)

    def publish(self, time_ns: int) -> None:
        device = self.device
        if self._info.get_subscription_count():
            self._info.publish(self._calibration(time_ns))
        if self._image.get_subscription_count():
            place = pose_at(self.simulation, self.robot, time_ns)
            picture = self._coded(self._view.render(self.simulation, place, without=self.robot))
            step = picture.nbytes // device.height
            msg = Image(height=device.height, width=device.width, encoding=device.encoding, step=step)
            msg.header.stamp, msg.header.frame_id = stamp_of(time_ns), device.frame
            msg.data = np.ascontiguousarray(picture).tobytes()
            self._image.publish(msg)

    def _coded(self, picture: Picture) -> Picture:
        """Add noise to a BGR image, and convert it to the camera's encoding."""
        if self.device.noise:
            shake = self.chance.standard_normal(picture.shape, np.float32) * np.float32(255.0 * self.device.noise)
            picture = np.clip(picture + shake, 0, 255).astype(np.uint8)
        if self.device.encoding == "mono8":
            return cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY).astype(np.uint8)
        return picture if self.device.encoding == "bgr8" else picture[:, :, ::-1]

    def _calibration(self, time_ns: int) -> CameraInfo:
        device, view = self.device, self._view
        msg = CameraInfo(height=device.height, width=device.width, distortion_model="plumb_bob", d=[0.0] * 5)
        msg.header.stamp, msg.header.frame_id = stamp_of(time_ns), device.frame
        f, cx, cy = view.focal, (device.width + 1) / 2, (device.height + 1) / 2
        msg.k = [f, 0.0, cx, 0.0, f, cy, 0.0, 0.0, 1.0]
        msg.r = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]
        msg.p = [f, 0.0, cx, 0.0, 0.0, f, cy, 0.0, 0.0, 0.0, 1.0, 0.0]
        return msg


def view_of(device: CameraDevice, width: int = 0, height: int = 0) -> View:
    """Return the view of a camera, in its own or another size."""
    assert device.pose is not None
    pose = device.pose
    turn = float(np.arctan2(pose[1, 0], pose[0, 0]))
    tilt = float(np.arcsin(np.clip(-pose[2, 0], -1.0, 1.0)))
    x, y, z = (float(number) for number in pose[:3, 3])
    return View((x, y, turn), max(z, 0.02), tilt, device.fov, width or device.width, height or device.height, device.far)


__all__ = ["CameraPublisher", "view_of"]
