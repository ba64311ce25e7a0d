"""Simulated devices: each makes its messages for a point in simulated time."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from builtin_interfaces.msg import Time
from gazebo_msgs.msg import ContactsState, ContactState
from geometry_msgs.msg import Quaternion
from rclpy.qos import QoSProfile
from sensor_msgs.msg import Imu, JointState
from std_msgs.msg import Float64

from coursekit.geometry.plane import Pose2D
from coursekit.sim.robot import GRAVITY, Robot
from coursekit.sim.simulation import Simulation

from .devices import BumpDevice, Device, ImuDevice, JointDevice, MotorDevice, RayDevice
from .ray_messages import RAY_TYPES

if TYPE_CHECKING:
    from rclpy.node import Node

SENSOR = QoSProfile(depth=5)
"""Reliable, which is compatible with all subscriptions."""


def stamp_of(time_ns: int) -> Time:
    """Convert nanoseconds to a message."""
    return Time(sec=time_ns // 1_000_000_000, nanosec=time_ns % 1_000_000_000)


def heading(theta: float) -> Quaternion:
    """Convert a heading to a quaternion."""
    return Quaternion(z=math.sin(theta / 2), w=math.cos(theta / 2))


def pose_at(simulation: Simulation, robot: Robot, time_ns: int) -> Pose2D:
    """Return a robot's pose at a time up to one step after the physics."""
    rest = (time_ns - simulation.now_ns) * 1e-9
    x, y, theta = robot.place
    speed = robot.body.velocity
    return Pose2D(x + speed.x * rest, y + speed.y * rest, theta + robot.body.angular_velocity * rest)


class Nobody:
    """A publisher that has no topic."""

    def get_subscription_count(self) -> int:
        """Return 0."""
        return 0

    def publish(self, _msg: object) -> None:
        """Do nothing."""


class SensorPublisher:
    """A device of a simulated robot; the k-th message is for time `begin + k / rate`, the next one is due at `due_ns`."""

    def __init__(self, node: Node, simulation: Simulation, robot: Robot, device: Device, seed: int, begin_ns: int) -> None:
        self.node, self.simulation, self.robot, self.device = node, simulation, robot, device
        self.chance = np.random.default_rng(seed)
        self.publishers: list[Any] = []
        self._begin, self._count, self.due_ns = begin_ns, 0, begin_ns
        self.open()

    def work(self) -> None:
        """Make the message that is due, if it has subscribers."""
        due = self.due_ns
        self._count += 1
        self.due_ns = self._begin + round(self._count * 1e9 / self.device.rate)
        self.publish(due)

    def restart(self, begin_ns: int) -> None:
        """Restart at a time."""
        self._begin, self._count, self.due_ns = begin_ns, 0, begin_ns

    def publisher(self, kind: type[Any], topic: str, qos: QoSProfile | int = 10) -> Any:
        """Make a publisher that is closed with the sensor; without a topic, one without subscribers."""
        if not topic:
            return Nobody()
        publisher = self.node.create_publisher(kind, topic, qos)
        self.publishers.append(publisher)
        return publisher

    def open(self) -> None:
        """Create publishers and subscriptions."""

    def publish(self, time_ns: int) -> None:
        """Publish the message for a time."""

    def close(self) -> None:
        """Destroy publishers and subscriptions."""
        for publisher in self.publishers:
            self.node.destroy_publisher(publisher)


class ScanPublisher(SensorPublisher):
    """A simulated LiDAR."""

    device: RayDevice

    def open(self) -> None:
        kind, self._message = RAY_TYPES[self.device.output]
        self._out = self.publisher(kind, self.device.topic, SENSOR)

    def publish(self, time_ns: int) -> None:
        if not self._out.get_subscription_count():
            return
        lidar = self.device.lidar
        place = pose_at(self.simulation, self.robot, time_ns) @ lidar.mount
        ranges = lidar.measure(self.simulation.scan(lidar, self.robot, place), self.chance)
        msg = self._message(self.device, ranges)
        msg.header.stamp, msg.header.frame_id = stamp_of(time_ns), self.device.frame
        self._out.publish(msg)


class JointPublisher(SensorPublisher):
    """Publishes the angles of wheels and motorised joints; other joints are at 0."""

    device: JointDevice

    def open(self) -> None:
        self._out = self.publisher(JointState, self.device.topic, 10)

    def publish(self, time_ns: int) -> None:
        joints, robot, drive = self.device.joints, self.robot, self.robot.model.drive
        forward, _, turn = robot.wheels
        speeds = {}
        if drive is not None:
            half = turn * drive.separation / 2
            speeds = dict.fromkeys(drive.left, (forward - half) / drive.radius)
            speeds |= dict.fromkeys(drive.right, (forward + half) / drive.radius)
        msg = JointState(name=list(joints))
        msg.header.stamp = stamp_of(time_ns)
        msg.position = [robot.angles.get(name, 0.0) for name in joints]
        msg.velocity = [speeds.get(name, robot.motors.speeds.get(name, 0.0)) for name in joints]
        self._out.publish(msg)


class MotorPublisher(SensorPublisher):
    """A simulated motor: it subscribes, and publishes nothing."""

    device: MotorDevice

    def open(self) -> None:
        self._heard = self.node.create_subscription(Float64, self.device.topic, self._move, 10)

    def _move(self, msg: Float64) -> None:
        if math.isfinite(msg.data):
            self.robot.motors.command(self.device.joint, self.device.mode, msg.data)

    def close(self) -> None:
        self.node.destroy_subscription(self._heard)


class ImuPublisher(SensorPublisher):
    """A simulated inertial unit."""

    device: ImuDevice

    def open(self) -> None:
        self._out = self.publisher(Imu, self.device.topic, SENSOR)
        self._last: tuple[int, tuple[float, float]] | None = None

    def publish(self, time_ns: int) -> None:
        forward, left, turn = self.robot.velocity
        last, self._last = self._last, (time_ns, (forward, left))
        if not self._out.get_subscription_count():
            return
        device = self.device
        seconds = (time_ns - last[0]) * 1e-9 if last else 0.0
        ahead, aside = ((now - was) / seconds for now, was in zip((forward, left), last[1], strict=True)) if (
            last and seconds > 0) else (0.0, 0.0)  # fmt: skip
        noise = self.chance.standard_normal(3) * (device.turn_noise, device.push_noise, device.push_noise)
        msg = Imu(orientation=heading(pose_at(self.simulation, self.robot, time_ns).theta))
        msg.header.stamp, msg.header.frame_id = stamp_of(time_ns), device.frame
        msg.angular_velocity.z = turn + device.turn_bias + float(noise[0])
        push = msg.linear_acceleration
        push.x = ahead - turn * left + device.push_bias + float(noise[1])
        push.y = aside + turn * forward + device.push_bias + float(noise[2])
        push.z = GRAVITY
        self._out.publish(msg)


class BumpPublisher(SensorPublisher):
    """A simulated bumper."""

    device: BumpDevice

    def open(self) -> None:
        self._out = self.publisher(ContactsState, self.device.topic, SENSOR)

    def publish(self, time_ns: int) -> None:
        own = f"{self.robot.name}::{self.device.link}"
        msg = ContactsState()
        msg.header.stamp, msg.header.frame_id = stamp_of(time_ns), self.device.frame
        msg.states = [ContactState(collision1_name=own, collision2_name=name) for name in self.robot.contacts]
        self._out.publish(msg)


PUBLISHERS: dict[type, type[SensorPublisher]] = {
    RayDevice: ScanPublisher, JointDevice: JointPublisher, ImuDevice: ImuPublisher, BumpDevice: BumpPublisher,
    MotorDevice: MotorPublisher,
}  # fmt: skip
__all__ = ["PUBLISHERS", "SensorPublisher", "heading", "pose_at", "stamp_of"]
