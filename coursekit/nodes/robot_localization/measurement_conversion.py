"""Conversion of a sensor's message to a measurement in the filter's frames."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from coursekit.geometry.pose import Pose, between, compose, inverse
from coursekit.geometry.rotation import rpy_of
from coursekit.nav.fusion.measurement import Measurement, keep_in_plane
from coursekit.nav.fusion.state import ACCELERATION, ANGLES, ANGULAR, LINEAR, POSE, POSITION, SIZE, TWIST, Array, Mask
from coursekit.nodes.robot_localization.frames import Frames
from coursekit.nodes.robot_localization.geometry import quaternion, square, turned, turned_mask, turning, unit, vector
from coursekit.nodes.robot_localization.sources import Source

if TYPE_CHECKING:
    from geometry_msgs.msg import Quaternion as QuaternionMsg
    from geometry_msgs.msg import Twist
    from numpy.typing import NDArray
    from sensor_msgs.msg import Imu


class MeasurementConverter:
    """Converts poses, twists and accelerations to measurements; stores earlier poses of differential and relative sources.

    The methods raise TransformException if a transform is missing.
    """

    def __init__(self, frames: Frames, world: str, base: str, *, flat: bool, gravity: float) -> None:
        self._frames, self._world, self._base, self._flat, self._gravity = frames, world, base, flat, gravity
        self._before: dict[str, tuple[Pose, Array, int]] = {}
        self._first: dict[str, Pose] = {}

    def forget(self) -> None:
        """Discard the stored poses."""
        self._before.clear()
        self._first.clear()

    def _made(self, source: Source, what: str, time_ns: int, values: Array, covariance: Array, used: Mask) -> Measurement:
        if self._flat:
            keep_in_plane(values, covariance, used)
        return Measurement(f"{source.name}_{what}", time_ns, values, covariance, used, source.thresholds[what])

    # -- poses

    def pose(
        self, source: Source, frame: str, stamp_ns: int, pose: Pose, covariance: NDArray[np.float64]
    ) -> Measurement | None:
        """A pose in a fixed frame; None for the first pose of a differential source."""
        used, own = source.part("pose"), square(covariance)
        if source.differential:
            return self._difference(source, stamp_ns, pose, own, used)
        seat = self._frames.pose(self._world, frame or self._world, stamp_ns)
        here = compose(seat, between(self._first.setdefault(source.name, pose), pose) if source.relative else pose)
        return self._absolute(source, stamp_ns, here, own, used, turning(seat))

    def heading(
        self, source: Source, frame: str, stamp_ns: int, q: QuaternionMsg, covariance: NDArray[np.float64]
    ) -> Measurement | None:
        """The orientation of an IMU; its message's frame gives its mounting on the robot."""
        seat = self._frames.pose(self._base, frame or self._base, stamp_ns)
        pose = compose((0.0, 0.0, 0.0, *unit(q)), inverse((0.0, 0.0, 0.0, *seat[3:])))
        own = np.zeros((6, 6))
        own[3:, 3:] = square(covariance)
        about = turning((0.0, 0.0, 0.0, *quaternion((0.0, 0.0, rpy_of(seat[3:])[2]))))
        used = source.part("pose")
        if source.differential:
            return self._difference(source, stamp_ns, pose, own, used)
        if source.relative:
            pose = between(self._first.setdefault(source.name, pose), pose)
        return self._absolute(source, stamp_ns, pose, own, used, about)

    def _absolute(self, source: Source, stamp_ns: int, pose: Pose, own: Array, used: Mask, rotation: Array) -> Measurement:
        values, covariance = np.zeros(SIZE), np.zeros((SIZE, SIZE))
        values[POSITION], values[ANGLES] = pose[:3], rpy_of(pose[3:])
        covariance[POSE, POSE] = turned(own, rotation)
        used[POSITION], used[ANGLES] = turned_mask(used[POSITION], rotation), turned_mask(used[ANGLES], rotation)
        return self._made(source, "pose", stamp_ns, values, covariance, used)

    def _difference(self, source: Source, stamp_ns: int, pose: Pose, own: Array, used: Mask) -> Measurement | None:
        """The velocity between the previous pose and this one."""
        before = self._before.get(source.name)
        self._before[source.name] = (pose, own, stamp_ns)
        if before is None or stamp_ns <= before[2]:
            return None
        seconds, way = (stamp_ns - before[2]) * 1e-9, between(before[0], pose)
        values, covariance, counts = np.zeros(SIZE), np.zeros((SIZE, SIZE)), np.zeros(SIZE, bool)
        values[LINEAR], values[ANGULAR] = np.array(way[:3]) / seconds, np.array(rpy_of(way[3:])) / seconds
        covariance[TWIST, TWIST] = (own + before[1]) * seconds
        counts[TWIST] = used[POSE]
        return self._made(source, "pose", stamp_ns, values, covariance, counts)

    # -- speeds and accelerations

    def twist(
        self, source: Source, frame: str, stamp_ns: int, twist: Twist, covariance: NDArray[np.float64], state: Array
    ) -> Measurement:
        """A velocity of a frame of the robot. `state` is the filter's: an off-centre sensor moves when the robot rotates."""
        seat = self._frames.pose(self._base, frame or self._base, stamp_ns)
        rotation, used = turning(seat), source.part("twist")
        values, own = np.zeros(SIZE), np.zeros((SIZE, SIZE))
        values[LINEAR] = rotation @ vector(twist.linear) + np.cross(seat[:3], state[ANGULAR])
        values[ANGULAR] = rotation @ vector(twist.angular)
        own[TWIST, TWIST] = turned(square(covariance), rotation)
        used[LINEAR], used[ANGULAR] = turned_mask(used[LINEAR], rotation), turned_mask(used[ANGULAR], rotation)
        return self._made(source, "twist", stamp_ns, values, own, used)

    def acceleration(self, source: Source, frame: str, stamp_ns: int, imu: Imu, state: Array) -> Measurement:
        """The acceleration of an IMU, which at rest measures 9.8 m/s² upwards; without gravity if its source says so."""
        seat = self._frames.pose(self._base, frame or self._base, stamp_ns)
        rotation, used, felt = turning(seat), source.part("acceleration"), vector(imu.linear_acceleration)
        if source.remove_gravity:
            felt = felt - turning(inverse(self._attitude(imu, seat, state)))[:, 2] * self._gravity
        values, own = np.zeros(SIZE), np.zeros((SIZE, SIZE))
        values[ACCELERATION] = rotation @ felt
        own[ACCELERATION, ACCELERATION] = turned(square(imu.linear_acceleration_covariance), rotation)
        used[ACCELERATION] = turned_mask(used[ACCELERATION], rotation)
        return self._made(source, "acceleration", stamp_ns, values, own, used)

    @staticmethod
    def _attitude(imu: Imu, seat: Pose, state: Array) -> Pose:
        """The orientation of an IMU in the world: from its message or, if that has none, from the filter."""
        if abs(imu.orientation_covariance[0] + 1) < 1e-9:
            body = (0.0, 0.0, 0.0, *quaternion(state[ANGLES]))
            return compose(body, (0.0, 0.0, 0.0, *seat[3:]))
        return (0.0, 0.0, 0.0, *unit(imu.orientation))
