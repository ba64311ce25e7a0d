"""Simulated sensors of Earth quantities: location, altitude, magnetic field and air pressure."""

from __future__ import annotations

import math
from typing import Any

from ros_gz_interfaces.msg import Altimeter
from sensor_msgs.msg import FluidPressure, MagneticField, NavSatFix, NavSatStatus

from coursekit.geometry.plane import Pose2D
from coursekit.sim.spherical_coordinates import pressure

from .devices import EarthDevice
from .sensor_publishers import SENSOR, SensorPublisher, pose_at, stamp_of

KINDS: dict[str, Any] = {
    "navsat": NavSatFix, "altimeter": Altimeter, "magnetometer": MagneticField, "air_pressure": FluidPressure,
}  # fmt: skip


class EarthPublisher(SensorPublisher):
    """A receiver of satellites, an altimeter, a magnetometer or a barometer."""

    device: EarthDevice

    def open(self) -> None:
        device, world = self.device, self.simulation.world
        self._globe = world.globe or device.globe
        lost = device.quantity == "navsat" and self._globe is None
        if lost:
            self.node.get_logger().warning(
                f"{self.robot.name}: {device.quantity} publishes nothing, as in Gazebo: add <spherical_coordinates> to the "
                "<world>"
            )
        self._message = getattr(self, f"_{device.quantity}")
        self._out = self.publisher(KINDS[device.quantity], "" if lost else device.topic, SENSOR)

    def publish(self, time_ns: int) -> None:
        if not self._out.get_subscription_count():
            return
        place = pose_at(self.simulation, self.robot, time_ns) @ self.device.mount
        msg = self._message(place)
        msg.header.stamp, msg.header.frame_id = stamp_of(time_ns), self.device.frame
        self._out.publish(msg)

    def _shaken(self, number: int) -> float:
        return float(self.chance.standard_normal()) * self.device.noise[number]

    def _navsat(self, place: Pose2D) -> NavSatFix:
        assert self._globe is not None
        across, up = self.device.noise
        latitude, longitude, altitude = self._globe.fix(
            place.x + self._shaken(0), place.y + self._shaken(0), self.device.height + self._shaken(1)
        )
        msg = NavSatFix(latitude=latitude, longitude=longitude, altitude=altitude)
        msg.status.status = NavSatStatus.STATUS_FIX
        if self.device.globe is not None:  # Gazebo Classic's plugin publishes more than the newer one's bridge
            msg.status.service = NavSatStatus.SERVICE_GPS
            msg.position_covariance_type = NavSatFix.COVARIANCE_TYPE_DIAGONAL_KNOWN
            msg.position_covariance[0] = msg.position_covariance[4] = across**2
            msg.position_covariance[8] = up**2
        return msg

    def _altimeter(self, place: Pose2D) -> Altimeter:
        return Altimeter(
            vertical_position=self._shaken(0), vertical_velocity=self._shaken(1), vertical_reference=self.device.height
        )

    def _magnetometer(self, place: Pose2D) -> MagneticField:
        x, y, z = self.simulation.world.magnetism
        c, s = math.cos(self.robot.place.theta), math.sin(self.robot.place.theta)
        msg = MagneticField()
        field = msg.magnetic_field
        field.x, field.y, field.z = c * x + s * y + self._shaken(0), c * y - s * x + self._shaken(0), z + self._shaken(1)
        return msg

    def _air_pressure(self, place: Pose2D) -> FluidPressure:
        felt = pressure(self.device.height) + self._shaken(0)
        return FluidPressure(fluid_pressure=felt, variance=self.device.noise[0] ** 2)


__all__ = ["EarthPublisher"]
