"""Polygon: a closed line. GridCells: squares on the floor. PointStamped: a ball, or the last few."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from coursekit.tf import compose
from coursekit.view.scene import Pose, Scene
from coursekit.view.scene_shapes import Lines, Triangles, ball, box, colour_of, scattered

from .display import StampedDisplay
from .kept import KeptDisplay

if TYPE_CHECKING:
    from collections.abc import Iterable

    from geometry_msgs.msg import Point, Point32
    from geometry_msgs.msg import PointStamped as PointMsg
    from geometry_msgs.msg import PolygonStamped as PolygonMsg
    from nav_msgs.msg import GridCells as GridCellsMsg

    from coursekit.view.scene_stage import Stage

_THIN = 0.002
"""The height of a cell [m]"""


def places(points: Iterable[Point | Point32]) -> np.ndarray:
    """Convert a list of points to an array (n, 3); ValueError if a coordinate is not finite."""
    places = np.array([(point.x, point.y, point.z) for point in points], float).reshape(-1, 3)
    if not np.isfinite(places).all():
        raise ValueError("Message contained invalid floating point values (nans or infs)")
    return places


class _Points(StampedDisplay):
    def points_of(self, points: Iterable[Point | Point32], scene: Scene) -> np.ndarray | None:
        """Return the points, or None after reporting invalid ones."""
        try:
            checked = places(points)
        except ValueError as error:
            self.say("Message", "Error", str(error))
            scene.clear(self.key)
            return None
        self.unsay("Message")
        return checked

    @property
    def colour(self) -> tuple[float, float, float, float]:
        """The colour set in the options."""
        return colour_of(self.options["color"], self.options["alpha"])


class Polygon(_Points):
    """The newest polygon, for example a robot's footprint."""

    kind = "Polygon"

    def show(self, msg: PolygonMsg, pose: Pose, stage: Stage, scene: Scene) -> None:
        """Draw lines from corner to corner and back to the first."""
        corners = self.points_of(msg.polygon.points, scene)
        if corners is None:
            return
        self.say("Polygon", "Ok", f"{len(corners)} points")
        edges = np.stack([corners, np.roll(corners, -1, axis=0)], axis=1).reshape(-1, 3)
        scene.put(self.key, "polygon", *([Lines(edges, self.colour, pixels=2.0)] if len(corners) else []), pose=pose)


class GridCells(_Points):
    """The newest cells, each centred on its point."""

    kind = "GridCells"

    def show(self, msg: GridCellsMsg, pose: Pose, stage: Stage, scene: Scene) -> None:
        """Draw a flat box for each cell."""
        centres = self.points_of(msg.cells, scene)
        if centres is None:
            return
        if not msg.cell_width or not msg.cell_height:
            self.say("Message", "Error", f"Cells of {msg.cell_width:g} by {msg.cell_height:g} m cannot be seen")
            return
        self.say("Cells", "Ok", f"{len(centres)} cells of {msg.cell_width:.3g} by {msg.cell_height:.3g} m")
        body = scattered(box(msg.cell_width, msg.cell_height, _THIN), centres)
        scene.put(self.key, "cells", *([Triangles(*body, self.colour)] if len(centres) else []), pose=pose)


class PointStamped(KeptDisplay, _Points):
    """The last `history_length` points."""

    kind = "PointStamped"

    def show(self, msg: PointMsg, pose: Pose, stage: Stage, scene: Scene) -> None:
        """Draw a ball of `radius`."""
        if self.points_of([msg.point], scene) is None:
            return
        vertices, faces = ball()
        self.keep(scene, Triangles(vertices * 2 * self.options["radius"], faces, self.colour))
        self.move(pose, scene)

    def move(self, pose: Pose, scene: Scene) -> None:
        """Move the newest point to its position in its frame; earlier ones stay."""
        point = self.shown.point
        super().move(compose(pose, (point.x, point.y, point.z, 0.0, 0.0, 0.0, 1.0)), scene)
