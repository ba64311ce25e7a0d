"""Axes: three bars along x (red), y (green) and z (blue) of a frame."""

from __future__ import annotations

from typing import TYPE_CHECKING

from coursekit.view.scene import HERE, Scene
from coursekit.view.scene_shapes import Triangles, tube

from .display import Display, NoTransform

if TYPE_CHECKING:
    from coursekit.view.scene_stage import Stage

_ORDERS = ([0, 1, 2], [2, 0, 1], [1, 2, 0])
_COLOURS = ((0.86, 0.2, 0.18), (0.2, 0.68, 0.3), (0.18, 0.42, 0.85))


def axes(length: float, radius: float, alpha: float = 1.0) -> tuple[Triangles, ...]:
    """Return the three bars of `length` metres."""
    vertices, faces = tube(0.0, length, radius, sides=10)
    pairs = zip(_ORDERS, _COLOURS, strict=True)
    return tuple(Triangles(vertices[:, order], faces, (*colour, alpha)) for order, colour in pairs)


class Axes(Display):
    """The axes of `reference_frame`; '' is the fixed frame."""

    kind = "Axes"

    def draw(self, stage: Stage, scene: Scene) -> None:
        """Draw the axes once; follow the frame."""
        frame = self.options["reference_frame"]
        try:
            pose = stage.pose(frame) if frame else HERE
        except NoTransform as error:
            self.say("Transform", "Error", str(error))
            scene.clear(self.key)
            return
        self.say("Transform", "Ok", "Transform OK")
        if not scene.has(self.key, "axes"):
            scene.put(self.key, "axes", *axes(self.options["length"], self.options["radius"], self.options["alpha"]))
        scene.place(self.key, "axes", pose)
