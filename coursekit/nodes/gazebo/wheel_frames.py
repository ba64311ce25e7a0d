"""`publish_wheel_tf` of drives: the frames of their wheels, if nobody publishes joint states."""

from __future__ import annotations

import math

import numpy as np
from tf2_msgs.msg import TFMessage

from coursekit.geometry.plane import Array

from .devices import WheelDevice
from .gz_publishers import transform_of
from .model_file import ModelFile
from .sensor_publishers import SensorPublisher, stamp_of


def wheels_of(model: ModelFile, joints: tuple[str, ...], topic: str, rate: float, node: str) -> WheelDevice:
    """Return a drive's wheel frames; their parent is the link that fixed joints are merged into, as in Gazebo."""
    assert model.robot is not None
    wheels = []
    for name in joints:
        told = model.robot.joints[name]
        parent = model.lumped.get(told.parent, told.parent)
        pose = np.linalg.inv(model.links[parent].pose) @ model.axles[name]
        x, y, z = map(float, told.axis)
        wheels.append((name, parent, told.child, tuple(pose.ravel().tolist()), (x, y, z)))
    return WheelDevice(topic, "", rate, node, tuple(wheels))


def turned(pose: Array, axis: tuple[float, float, float], angle: float) -> Array:
    """Return a pose rotated about one of its own axes."""
    x, y, z = np.array(axis) / (math.hypot(*axis) or 1.0)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    turned = pose.copy()
    turned[:3, :3] = pose[:3, :3] @ (np.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross)
    return turned


class WheelPublisher(SensorPublisher):
    """Publishes the wheels' frames."""

    device: WheelDevice

    def open(self) -> None:
        self._out = self.publisher(TFMessage, self.device.topic, 100)

    def publish(self, time_ns: int) -> None:
        transforms = []
        for joint, parent, child, pose, axis in self.device.wheels:
            transform = transform_of(turned(np.array(pose).reshape(4, 4), axis, self.robot.angles.get(joint, 0.0)))
            transform.header.stamp, transform.header.frame_id, transform.child_frame_id = stamp_of(time_ns), parent, child
            transforms.append(transform)
        self._out.publish(TFMessage(transforms=transforms))


__all__ = ["WheelPublisher", "wheels_of"]
