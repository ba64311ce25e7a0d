"""Grid: squares in the plane z = 0 of a frame."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from coursekit.view.scene import Scene
from coursekit.view.scene_shapes import Lines, colour_of

from .display import Display, NoTransform

if TYPE_CHECKING:
    from coursekit.view.scene_stage import Stage


class Grid(Display):
    """Squares of `cell_size` metres."""

    kind = "Grid"

    def draw(self, stage: Stage, scene: Scene) -> None:
        """Draw it once; follow its frame."""
        if not scene.has(self.key, "grid"):
            scene.put(self.key, "grid", self._lines())
        frame = self.options["reference_frame"]
        if not frame:
            return
        try:
            scene.place(self.key, "grid", stage.pose(frame))
            self.say("Transform", "Ok", "Transform OK")
        except NoTransform as error:
            self.say("Transform", "Error", str(error))

    def _lines(self) -> Lines:
        count = max(1, min(1000, int(self.options["plane_cell_count"])))
        at = (np.arange(count + 1) - count / 2) * self.options["cell_size"]
        edge = np.full_like(at, at[-1])
        flat = np.zeros_like(at)
        along = np.stack([np.stack([-edge, at, flat], 1), np.stack([edge, at, flat], 1)], 1).reshape(-1, 3)
        return Lines(np.concatenate([along, along[:, [1, 0, 2]]]), colour_of(self.options["color"], self.options["alpha"]))
