"""A flying burger, for those who have no camera."""

from __future__ import annotations

import random
from typing import Any

import cv2
import numpy

_LAYERS = (  # from the top: share of the height, and colour (BGR)
    (0.30, (60, 130, 210)),
    (0.10, (70, 170, 60)),
    (0.22, (35, 60, 100)),
    (0.10, (60, 200, 250)),
    (0.28, (70, 140, 220)),
)
_BLUE_OF_THE_SKY = (230, 190, 130)


class Burgers:
    """Draws burgers that move a step with each image and bounce off the edges.

    >>> Burgers(320, 240).draw().shape
    (240, 320, 3)
    """

    def __init__(self, width: int, height: int, count: int = 3, seed: int = 1) -> None:
        self._size = (width, height)
        self._side = max(8, min(width, height) // 5)
        draw = random.Random(seed)
        self._places = [[draw.uniform(0, 1) * (edge - self._side) for edge in self._size] for _ in range(count)]
        self._steps = [[draw.choice((-1, 1)) * draw.uniform(2, 6) for _ in self._size] for _ in range(count)]

    def draw(self) -> Any:
        """Return the next image (BGR), an array of height by width by 3 bytes."""
        width, height = self._size
        image = numpy.full((height, width, 3), _BLUE_OF_THE_SKY, numpy.uint8)
        for place, step in zip(self._places, self._steps, strict=True):
            self._move(place, step)
            self._draw_one(image, round(place[0]), round(place[1]))
        return image

    def _move(self, place: list[float], step: list[float]) -> None:
        for axis, edge in enumerate(self._size):
            place[axis] += step[axis]
            if not 0 <= place[axis] <= edge - self._side:
                step[axis] = -step[axis]
                place[axis] = min(max(place[axis], 0), edge - self._side)

    def _draw_one(self, image: Any, x: int, y: int) -> None:
        top = float(y)
        for share, colour in _LAYERS:
            bottom = top + share * self._side
            cv2.rectangle(image, (x, round(top)), (x + self._side, round(bottom)), colour, -1)
            top = bottom
