"""Map: an occupancy grid as a picture on the floor."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from coursekit.tf import compose
from coursekit.view.scene import Pose, Scene
from coursekit.view.scene_shapes import Picture

from .display import StampedDisplay
from .poses import numbers

if TYPE_CHECKING:
    from coursekit.view.scene_stage import Stage

_UNKNOWN, _BELOW = (112, 137, 134), 0.004
_FREE, _ILLEGAL = 255, (255, 0, 255)


def painted(cells: np.ndarray, scheme: str = "map") -> np.ndarray:
    """(rows, columns, 4) RGBA of a grid of -1 and 0 .. 100, its uppermost row first, in RViz's colours.

    'map': white is free, black occupied, greenish grey unknown. 'costmap': from blue to red, free is clear.
    """
    table = np.zeros((256, 4), np.uint8)
    table[:] = (*_ILLEGAL, 255)
    level = np.arange(101)
    if scheme == "costmap":
        table[:101, 0] = table[:101, 2] = 255
        table[:101, 0], table[:101, 2] = level * 255 // 100, 255 - level * 255 // 100
        table[:101, 1] = 0
        table[0] = (0, 0, 0, 0)
        table[99], table[100] = (0, 255, 255, 255), (255, 0, 255, 255)
    else:
        table[:101, :3] = (255 - level * 255 // 100)[:, None]
    table[255] = (*_UNKNOWN, 255) if scheme != "costmap" else (*_UNKNOWN, 120)
    result: np.ndarray = table[cells.astype(np.int8).view(np.uint8)][::-1]
    return result


class Map(StampedDisplay):
    """The newest map."""

    kind = "Map"

    def show(self, msg: Any, pose: Pose, stage: Stage, scene: Scene) -> None:
        """Paint it."""
        info = msg.info
        if not info.width or not info.height or info.width * info.height != len(msg.data):
            self.say("Map", "Error", f"{info.width} x {info.height} cells, but {len(msg.data)} numbers in data")
            scene.clear(self.key)
            return
        cells = np.asarray(msg.data, np.int8).reshape(info.height, info.width)
        self.say("Map", "Ok", f"{info.width} x {info.height} cells of {info.resolution:.3g} m")
        size = info.width * info.resolution, info.height * info.resolution
        image = painted(cells, self.options["color_scheme"])
        scene.put(self.key, "map", Picture(image, *size, self.options["alpha"]))
        self.move(pose, scene)

    def move(self, pose: Pose, scene: Scene) -> None:
        """A little below the floor, so that the grid is seen."""
        x, y, z, *turn = numbers(self.shown.info.origin)
        if scene.has(self.key, "map"):
            scene.place(self.key, "map", compose(pose, (x, y, z - _BELOW, *turn)))  # type: ignore[arg-type]
