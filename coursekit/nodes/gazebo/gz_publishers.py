"""Simulated devices of only the newer Gazebo: poses and contacts of a model."""

from __future__ import annotations

import math

import numpy as np
from geometry_msgs.msg import TransformStamped
from ros_gz_interfaces.msg import Contact, Contacts, Entity
from tf2_msgs.msg import TFMessage

from coursekit.geometry.plane import Array

from .devices import PoseDevice, TouchDevice
from .sensor_publishers import SensorPublisher, heading, pose_at, stamp_of


class PosePublisher(SensorPublisher):
    """gz::sim::systems::PosePublisher: the poses of a model and of its links."""

    device: PoseDevice

    def open(self) -> None:
        self._out = self.publisher(TFMessage, self.device.topic, 10)

    def publish(self, time_ns: int) -> None:
        if not self._out.get_subscription_count():
            return
        device, transforms = self.device, []
        if device.world:
            place = pose_at(self.simulation, self.robot, time_ns)
            whole = TransformStamped(child_frame_id=device.model)
            whole.header.frame_id = device.world
            whole.transform.translation.x, whole.transform.translation.y = place.x, place.y
            whole.transform.rotation = heading(place.theta)
            transforms.append(whole)
        for name, pose in device.links:
            transform = transform_of(np.array(pose).reshape(4, 4))
            transform.header.frame_id, transform.child_frame_id = device.model, f"{device.model}/{name}"
            transforms.append(transform)
        for transform in transforms:
            transform.header.stamp = stamp_of(time_ns)
        self._out.publish(TFMessage(transforms=transforms))


def transform_of(pose: Array) -> TransformStamped:
    """Convert a 4x4 matrix to a message without header."""
    msg = TransformStamped()
    at, turned = msg.transform.translation, msg.transform.rotation
    at.x, at.y, at.z = (float(number) for number in pose[:3, 3])
    w = math.sqrt(max(0.0, 1.0 + float(np.trace(pose[:3, :3])))) / 2
    if w < 1e-6:  # a half turn about an axis
        turned.x, turned.y, turned.z = (math.sqrt(max(0.0, (1.0 + float(pose[i, i])) / 2)) for i in range(3))
        turned.w = 0.0
        return msg
    skew = (pose[2, 1] - pose[1, 2], pose[0, 2] - pose[2, 0], pose[1, 0] - pose[0, 1])
    turned.x, turned.y, turned.z, turned.w = (*(float(number) / (4 * w) for number in skew), w)
    return msg


class TouchPublisher(SensorPublisher):
    """A contact sensor: the model's current contacts."""

    device: TouchDevice

    def open(self) -> None:
        self._out = self.publisher(Contacts, self.device.topic, 10)

    def publish(self, time_ns: int) -> None:
        if not self.robot.contacts or not self._out.get_subscription_count():
            return
        own = Entity(name=f"{self.robot.name}::{self.device.link}", type=Entity.COLLISION)
        others = [Entity(name=name, type=Entity.COLLISION) for name in self.robot.contacts]
        msg = Contacts(contacts=[Contact(collision1=own, collision2=other) for other in others])
        msg.header.stamp, msg.header.frame_id = stamp_of(time_ns), self.device.frame
        self._out.publish(msg)


__all__ = ["PosePublisher", "TouchPublisher", "transform_of"]
