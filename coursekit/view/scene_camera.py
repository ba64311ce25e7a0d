"""The camera of a scene."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from .scene import Scene

FIELD = math.radians(45)
"""The vertical field of view [rad]"""
NEAR = 0.02
AFAR = 30.0
"""The distance factor of a flat camera, with a field narrower by as much: parallel lines then appear parallel."""


@dataclass(frozen=True)
class Camera:
    """At `distance` [m] from `target`, rotated by `yaw` and raised by `pitch` [rad], as in RViz's Orbit view."""

    distance: float = 5.0
    yaw: float = 0.9
    pitch: float = 0.5
    target: tuple[float, float, float] = (0.0, 0.0, 0.0)
    flat: bool = False
    """Parallel projection, as on a map: size does not depend on distance."""

    @property
    def stretch(self) -> float:
        """The factor by which the camera is really further away."""
        return AFAR if self.flat else 1.0

    def eye(self) -> np.ndarray:
        """Return the camera's position."""
        flat = math.cos(self.pitch)
        way = [flat * math.cos(self.yaw), flat * math.sin(self.yaw), math.sin(self.pitch)]
        return np.array(self.target) + self.distance * self.stretch * np.array(way)

    def seen(self, points: np.ndarray) -> np.ndarray:
        """Transform points (n, 3) to right, up and depth in the camera's frame [m]."""
        cy, sy, cp, sp = math.cos(self.yaw), math.sin(self.yaw), math.cos(self.pitch), math.sin(self.pitch)
        right, up, ahead = (-sy, cy, 0.0), (-sp * cy, -sp * sy, cp), (-cp * cy, -cp * sy, -sp)
        result: np.ndarray = (np.asarray(points, float) - self.eye()) @ np.array([right, up, ahead]).T
        return result

    def as_dict(self) -> dict[str, Any]:
        """Return the values for a configuration."""
        return {"distance": self.distance, "yaw": self.yaw, "pitch": self.pitch, "target": list(self.target)}


def camera_of(scene: Scene, keys: list[str], nearest: float = 0.5) -> Camera:
    """Return a camera that shows the things of these displays from a distance of at least `nearest` [m]."""
    bounds = scene.bounds(keys)
    if bounds is None:
        return Camera()
    low, high = bounds
    middle = (low + high) / 2
    radius = float(np.linalg.norm(high - low)) / 2
    distance = min(200.0, max(nearest, 1.1 * radius / math.sin(FIELD / 2)))
    return Camera(distance, target=(float(middle[0]), float(middle[1]), float(middle[2])))


__all__ = ["FIELD", "NEAR", "Camera", "camera_of"]
