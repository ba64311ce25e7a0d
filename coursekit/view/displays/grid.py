"""Grid: squares in the plane z = 0 of a frame."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from coursekit.view.scene import Scene
from coursekit.view.scene_shapes import Lines, colour_of

from .display import Display, NoTransform

if TYPE_CHECKING:
    from coursekit.view.scene_stage import Stage


FINER = 5
"""The number of fine subdivisions of a square, for reading off fifths: 0.2 m of a metre."""
MOST_FINE = 40
"""The maximum number of squares per side with fine lines, which would otherwise blur into grey."""
FAINT = 0.3
"""The alpha of the fine lines, relative to that of the grid."""


class Grid(Display):
    """Squares of `cell_size` metres, with fine lines within them."""

    kind = "Grid"

    def draw(self, stage: Stage, scene: Scene) -> None:
        """Draw the grid once; follow its frame."""
        if not scene.has(self.key, "grid"):
            scene.put(self.key, "grid", *self._lines())
        frame = self.options["reference_frame"]
        if not frame:
            return
        try:
            scene.place(self.key, "grid", stage.pose(frame))
            self.say("Transform", "Ok", "Transform OK")
        except NoTransform as error:
            self.say("Transform", "Error", str(error))

    def _lines(self) -> Iterator[Lines]:
        count = max(1, min(1000, int(self.options["plane_cell_count"])))
        fine, alpha = np.arange(count * FINER + 1), float(self.options["alpha"])
        if count <= MOST_FINE:
            yield self._across(count, fine[fine % FINER != 0] / FINER, FAINT * alpha)
        yield self._across(count, np.arange(count + 1.0), alpha)

    def _across(self, count: int, numbers: np.ndarray, alpha: float) -> Lines:
        """Return lines in both directions across the grid, at these distances from the edge in squares."""
        size = self.options["cell_size"]
        at, edge, flat = (numbers - count / 2) * size, np.full_like(numbers, count / 2 * size), np.zeros_like(numbers)
        along = np.stack([np.stack([-edge, at, flat], 1), np.stack([edge, at, flat], 1)], 1).reshape(-1, 3)
        return Lines(np.concatenate([along, along[:, [1, 0, 2]]]), colour_of(self.options["color"], alpha))
