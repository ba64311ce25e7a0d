"""From where a scene is looked at."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from .scene import Scene

FIELD = math.radians(45)
"""Height of what is seen, as an angle"""
NEAR = 0.02
AFAR = 30.0
"""So many times further away, and narrower by as much, a camera sees parallel lines as parallel to the eye."""


@dataclass(frozen=True)
class Camera:
    """At `distance` [m] from `target`, turned by `yaw` and raised by `pitch` [rad], as RViz's Orbit view."""

    distance: float = 5.0
    yaw: float = 0.9
    pitch: float = 0.5
    target: tuple[float, float, float] = (0.0, 0.0, 0.0)
    flat: bool = False
    """As a map shows it: what is far away is as large as what is near."""

    @property
    def stretch(self) -> float:
        """How many times further away it really is."""
        return AFAR if self.flat else 1.0

    def eye(self) -> np.ndarray:
        """Where it is."""
        flat = math.cos(self.pitch)
        way = [flat * math.cos(self.yaw), flat * math.sin(self.yaw), math.sin(self.pitch)]
        return np.array(self.target) + self.distance * self.stretch * np.array(way)

    def seen(self, points: np.ndarray) -> np.ndarray:
        """Points (n, 3) as right, up and depth [m] seen from it."""
        cy, sy, cp, sp = math.cos(self.yaw), math.sin(self.yaw), math.cos(self.pitch), math.sin(self.pitch)
        right, up, ahead = (-sy, cy, 0.0), (-sp * cy, -sp * sy, cp), (-cp * cy, -cp * sy, -sp)
        result: np.ndarray = (np.asarray(points, float) - self.eye()) @ np.array([right, up, ahead]).T
        return result

    def as_dict(self) -> dict[str, Any]:
        """For a configuration."""
        return {"distance": self.distance, "yaw": self.yaw, "pitch": self.pitch, "target": list(self.target)}


def camera_of(scene: Scene, keys: list[str], nearest: float = 0.5) -> Camera:
    """One that shows the things of these displays from not too near [m]."""
    bounds = scene.bounds(keys)
    if bounds is None:
        return Camera()
    low, high = bounds
    middle = (low + high) / 2
    radius = float(np.linalg.norm(high - low)) / 2
    distance = min(200.0, max(nearest, 1.1 * radius / math.sin(FIELD / 2)))
    return Camera(distance, target=(float(middle[0]), float(middle[1]), float(middle[2])))


__all__ = ["FIELD", "NEAR", "Camera", "camera_of"]
