"""The sensor elements common to both Gazebos: beams, images, noise, and Earth quantities."""

from __future__ import annotations

import math

from coursekit.geometry.plane import Array, Pose2D
from coursekit.sim.lidar import Lidar
from coursekit.sim.spherical_coordinates import SphericalCoordinates
from coursekit.urdf.xml_tree import Element

from .devices import EarthDevice
from .model_file import ModelFile
from .value_parsing import number, yaw_of

EARTH = {
    "navsat": ("position_sensing/horizontal/noise/stddev", "position_sensing/vertical/noise/stddev"),
    "gps": ("position_sensing/horizontal/noise/stddev", "position_sensing/vertical/noise/stddev"),
    "altimeter": ("vertical_position/noise/stddev", "vertical_velocity/noise/stddev"),
    "magnetometer": ("x/noise/stddev", "z/noise/stddev"),
    "air_pressure": ("pressure/noise/stddev", "pressure/noise/stddev"),
}
"""Sensor types, with the paths of the noise of their first and second value."""


def lidar_of(sensor: Element, ray: Element, rate: float, where: Array, model: ModelFile, floor: float) -> Lidar:
    """Return the beams of a `<ray>` or `<lidar>`, with notes on unsupported parts."""
    if number(ray, "scan/vertical/samples", 1) > 1:
        model.note(sensor, "has several layers; the middle one is simulated")
    if abs(abs(where[2, 2]) - 1.0) > 1e-3:
        model.note(sensor, "is tilted; it is simulated level")
    noise = ray.first("noise") or sensor.first("noise")
    return Lidar(
        beams=round(number(ray, "scan/horizontal/samples", 640) * number(ray, "scan/horizontal/resolution", 1.0)),
        angle_min=number(ray, "scan/horizontal/min_angle", 0.0),
        angle_max=number(ray, "scan/horizontal/max_angle", 0.0),
        range_min=number(ray, "range/min", 0.0),
        range_max=min(number(ray, "range/max", 10.0), 1e4),
        rate=rate,
        noise=number(noise, "stddev", 0.0),
        bias=number(noise, "mean", 0.0),
        mount=Pose2D(float(where[0, 3]), float(where[1, 3]), yaw_of(where)),
        height=float(where[2, 3]) - floor,
        upside_down=bool(where[2, 2] < 0),
    )


def shakes_of(sensor: Element) -> tuple[float, float, float, float]:
    """Return noise and bias of an `<imu>`: of angular velocity [rad/s] and of acceleration [m/s^2]."""
    imu = sensor.first("imu")
    turn, push = "angular_velocity/z/noise/", "linear_acceleration/x/noise/"
    turning = number(imu, turn + "stddev", 0.0), number(imu, turn + "bias_mean", 0.0)
    return *turning, number(imu, push + "stddev", 0.0), number(imu, push + "bias_mean", 0.0)


def picture_of(sensor: Element, camera: Element | None) -> tuple[int, int, float]:
    """Return width, height and field of view [rad] of a camera. Raises UrdfError for impossible values."""
    width, height = (round(number(camera, f"image/{side}", size)) for side, size in (("width", 320), ("height", 240)))
    if not (16 <= width <= 4096 and 16 <= height <= 4096):
        raise sensor.error(f"has pictures of {width}x{height}", "Give a width and height from 16 to 4096.")
    fov = number(camera, "horizontal_fov", 1.047)
    if not 0.05 <= fov <= math.pi - 0.05:
        raise sensor.error(f"has a horizontal_fov of {fov}", "Give one from 0.05 to 3.09 rad.")
    return width, height, fov


def earth_of(
    sensor: Element, topic: str, frame: str, rate: float, node: str, where: Array, floor: float,
    usual: SphericalCoordinates | None = None,
) -> EarthDevice:  # fmt: skip
    """Return a sensor of an Earth quantity; `usual` is the location of a world without its own."""
    kind = sensor.get("type") or ""
    told = sensor.first(kind)
    first, second = (number(told, path, 0.0) for path in EARTH[kind])
    return EarthDevice(
        topic, frame, rate, node, "navsat" if kind == "gps" else kind, Pose2D(float(where[0, 3]), float(where[1, 3]), 0.0),
        float(where[2, 3]) - floor, (first, second), usual,
    )  # fmt: skip


__all__ = ["EARTH", "earth_of", "lidar_of", "picture_of", "shakes_of"]
