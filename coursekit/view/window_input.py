"""Sliders and the mouse in OpenCV's windows: `cv2.createTrackbar`, `cv2.setMouseCallback` and related functions.

A program is told of them while it waits for a key, as in OpenCV: a slider that is pulled during a long computation has
its new position after the next `waitKey`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

Moved = Callable[[int], Any]
MouseMoved = Callable[[int, int, int, int, Any], Any]


@dataclass
class Trackbar:
    """A slider below a window's image; `low` and `high` bound its `value`.

    >>> bar = Trackbar("speed", 3, 10)
    >>> bar.move(12), bar.value
    (None, 10)
    """

    name: str
    value: int
    high: int
    moved: Moved | None = None
    """Called with the new value."""
    low: int = 0

    def move(self, value: int) -> None:
        """Move it, within its bounds, and tell the program if that changes it."""
        value = max(self.low, min(self.high, value))
        if value == self.value:
            return
        self.value = value
        if self.moved is not None:
            self.moved(value)


@dataclass(frozen=True)
class Mouse:
    """Where a program wants the events of the mouse."""

    moved: MouseMoved
    param: Any = None

    def tell(self, event: int, x: int, y: int, flags: int) -> None:
        """Call the program's function, with the place in pixels of the image."""
        self.moved(event, x, y, flags, self.param)
