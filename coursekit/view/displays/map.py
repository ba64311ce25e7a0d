"""Map: an occupancy grid as a picture on the floor."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING, Any

import numpy as np

from coursekit.interfaces import load
from coursekit.nodes.rviz.config import DisplayConfig
from coursekit.tf import compose
from coursekit.view.scene import Pose, Scene, Thing
from coursekit.view.scene_shapes import Picture

from .display import NoTransform, StampedDisplay
from .facts import Fact
from .poses import numbers

if TYPE_CHECKING:
    from map_msgs.msg import OccupancyGridUpdate
    from nav_msgs.msg import OccupancyGrid
    from rclpy.node import Node

    from coursekit.view.scene_stage import Stage

_UNKNOWN, _BELOW = (112, 137, 134), 0.004
_ILLEGAL = (255, 0, 255)


def painted(cells: np.ndarray, scheme: str = "map") -> np.ndarray:
    """Convert a grid of -1 and 0 .. 100 to RGBA (rows, columns, 4), top row first, in RViz's colours.

    'map': white is free, black occupied, greenish grey unknown. 'costmap': from blue to red, free is transparent.

    >>> painted(np.array([[0, 100, -1]])).tolist()
    [[[255, 255, 255, 255], [0, 0, 0, 255], [112, 137, 134, 255]]]
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

    def __init__(self, config: DisplayConfig, number: int) -> None:
        super().__init__(config, number)
        self._parts: deque[Any] = deque(maxlen=100)
        self._updates: Any = None

    def connect(self, node: Node) -> None:
        """Subscribe to the map, and to its partial updates on the topic with the suffix `_updates`."""
        super().connect(node)
        if self._subscription is not None and self._updates is None:
            kind = load("map_msgs/msg/OccupancyGridUpdate")
            self._updates = node.create_subscription(kind, f"{self.config.topic}_updates", self._parts.append, 10)

    def disconnect(self, node: Node) -> None:
        """Drop the subscriptions."""
        if self._updates is not None:
            node.destroy_subscription(self._updates)
        self._updates = None
        super().disconnect(node)

    def forget(self) -> None:
        """Forget the map and its updates."""
        super().forget()
        self._parts.clear()

    def draw(self, stage: Stage, scene: Scene) -> None:
        """Draw the newest map and its updates."""
        if self.count:
            super().draw(stage, scene)
        changed = False
        while self._parts and self.shown is not None:
            changed = self._change(self._parts.popleft()) or changed
        if changed:
            self._paint(scene)
            self._stay(stage, scene)

    def _change(self, part: OccupancyGridUpdate) -> bool:
        """Apply a partial update to the shown map. Returns whether it fits."""
        info = self.shown.info
        fits = 0 <= part.x <= info.width - part.width and 0 <= part.y <= info.height - part.height
        if not fits or part.width * part.height != len(part.data):
            size = f"{part.width} x {part.height} cells at ({part.x}, {part.y})"
            self.say("Update", "Error", f"An update of {size} is outside")
            return False
        self.unsay("Update")
        cells = np.asarray(self.shown.data, np.int8).reshape(info.height, info.width)
        below, left = part.y, part.x
        cells[below : below + part.height, left : left + part.width] = np.reshape(part.data, (part.height, part.width))
        self.shown.data = cells.ravel().tolist()
        return True

    def show(self, msg: OccupancyGrid, pose: Pose, stage: Stage, scene: Scene) -> None:
        """Paint the map."""
        info = msg.info
        if not info.width or not info.height or info.width * info.height != len(msg.data):
            self.say("Map", "Error", f"{info.width} x {info.height} cells, but {len(msg.data)} numbers in data")
            scene.clear(self.key)
            return
        self.say("Map", "Ok", f"{info.width} x {info.height} cells of {info.resolution:.3g} m")
        self._paint(scene)
        self.move(pose, scene)

    def facts(self, name: str, thing: Thing, here: np.ndarray, stage: Stage) -> list[Fact]:
        """Return the clicked cell and its value."""
        info = self.shown.info
        column, row = (int(here[axis] // info.resolution) for axis in (0, 1))
        if not (0 <= column < info.width and 0 <= row < info.height):
            return super().facts(name, thing, here, stage)
        value = int(self.shown.data[row * info.width + column])
        word = "unknown" if value < 0 else "free" if value == 0 else "occupied" if value == 100 else "between"
        cell = [("Cell", f"column {column}, row {row}"), ("Value", f"{value} ({word})")]
        return [*cell, *super().facts(name, thing, here, stage)]

    def _paint(self, scene: Scene) -> None:
        info = self.shown.info
        cells = np.asarray(self.shown.data, np.int8).reshape(info.height, info.width)
        size = info.width * info.resolution, info.height * info.resolution
        image = painted(cells, self.options["color_scheme"])
        scene.put(self.key, "map", Picture(image, *size, self.options["alpha"]))

    def pose_of(self, msg: OccupancyGrid, stage: Stage) -> Pose:
        """Return the current pose of the map's frame, else the last: as in RViz, a map outlives its stamp."""
        try:
            return stage.pose(msg.header.frame_id, stage.now())
        except NoTransform:
            return stage.pose(msg.header.frame_id)

    def move(self, pose: Pose, scene: Scene) -> None:
        """Move the map to a little below the floor, to keep the grid visible."""
        x, y, z, *turn = numbers(self.shown.info.origin)
        if scene.has(self.key, "map"):
            scene.place(self.key, "map", compose(pose, (x, y, z - _BELOW, *turn)))  # type: ignore[arg-type]
