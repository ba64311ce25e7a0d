"""A camera's image of a world: upright walls column by column with their textures, floor and sky."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from coursekit.geometry.plane import Pose2D

from .view_kernels import measure, paint, sky_and_floor
from .view_scene import ViewScene

Picture = NDArray[np.uint8]


class View:
    """A pinhole camera on a robot. Images are height x width x 3, uint8, blue first.

    >>> from coursekit.sim import Simulation, read_world
    >>> simulation = Simulation(read_world("world: w\\ncircles: [{name: c, center: [2, 0], radius: 0.5, colour: red}]"))
    >>> picture = View(width=64, height=48).render(simulation, Pose2D())
    >>> blue, green, red = picture[24, 32].tolist(); red > 2 * blue
    True
    """

    def __init__(
        self, mount: tuple[float, float, float] = (0.0, 0.0, 0.0), above: float = 0.2, tilt: float = 0.0, fov: float = 1.2,
        width: int = 640, height: int = 480, far: float = 50.0,
    ) -> None:  # fmt: skip
        self.mount, self.above, self.tilt, self.far = Pose2D(*mount), above, tilt, far
        self.width, self.height = width, height
        self.focal = width / 2 / math.tan(fov / 2)
        """Focal length in pixels."""
        columns = (np.arange(width) - (width - 1) / 2) / self.focal
        self._slopes = -columns
        self._horizon = (height - 1) / 2 - self.focal * math.tan(tilt)

    def render(self, simulation: Any, place: Pose2D, without: Any = None) -> Picture:
        """Return the image from a robot at `place`; `without` is the robot that carries the camera."""
        scene = ViewScene.of(simulation)
        at = place @ self.mount
        picture: Picture = np.empty((self.height, self.width, 3), np.uint8)
        sky_and_floor(picture, self._slopes, self._horizon, self.focal, self.above, *at, scene.floor)
        edges, looks = scene.edges(None if without is None else without.body)
        paint(
            picture, self._slopes, self._horizon, self.focal, self.above, self.far, *at, edges, looks, scene.textures
        )
        return picture


    def depths(self, simulation: Any, place: Pose2D, without: Any = None) -> NDArray[np.float32]:
        """Return the depth image [m], height x width, from a robot at `place`; inf beyond the range.

        >>> from coursekit.sim import Simulation, read_world
        >>> simulation = Simulation(read_world("world: w\\nboxes: [{name: b, center: [3, 0], size: [1, 4]}]"))
        >>> depths = View(width=64, height=48).depths(simulation, Pose2D())
        >>> float(depths[20, 32]), float(depths[20, 0])
        (2.5, 2.5)
        """
        scene, at = ViewScene.of(simulation), place @ self.mount
        depths = np.empty((self.height, self.width), np.float32)
        edges, _ = scene.edges(None if without is None else without.body)
        measure(depths, self._slopes, self._horizon, self.focal, self.above, self.far, *at, edges)
        return depths


__all__ = ["View"]
