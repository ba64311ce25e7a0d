"""Points of a line, step by step. In ROS 2: nav2_simple_commander.line_iterator."""

from __future__ import annotations

import math


class LineIterator:
    """Steps from (x0, y0) to (x1, y1) by `step_size` along x, or along y if x stays the same.

    >>> line = LineIterator(0, 0, 2, 1); points = []
    >>> while line.isValid():
    ...     points.append((line.getX(), line.getY()))
    ...     line.advance()
    >>> points
    [(0, 0), (1.0, 0.5), (2, 1.0)]
    """

    def __init__(self, x0: float, y0: float, x1: float, y1: float, step_size: float = 1.0) -> None:
        """Raise TypeError for a value that is not a number, ValueError for a line or a step without length."""
        for name, value in (("x0", x0), ("y0", y0), ("x1", x1), ("y1", y1), ("step_size", step_size)):
            if type(value) not in (int, float):
                raise TypeError(f"{name} must be a number (int or float)")
        if step_size <= 0:
            raise ValueError("step_size must be a positive number")
        if (x0, y0) == (x1, y1):
            raise ValueError("Line has zero length (All 4 points have same coordinates)")
        self.x0_, self.y0_, self.x1_, self.y1_, self.step_size_ = x0, y0, x1, y1, step_size
        self.x_, self.y_ = x0, y0
        self.valid_ = True
        if x1 != x0:
            self.m_ = (y1 - y0) / (x1 - x0)
            self.b_ = y1 - self.m_ * x1

    def isValid(self) -> bool:
        """Whether the current point is on the line."""
        return self.valid_

    def advance(self) -> None:
        """Go to the next point; beyond the end the line is no longer valid."""
        upright = self.x1_ == self.x0_
        now, first, last = (self.y_, self.y0_, self.y1_) if upright else (self.x_, self.x0_, self.x1_)
        if now == last:
            self.valid_ = False
            return
        low, high = min(first, last), max(first, last)
        moved = round(self.clamp(now + math.copysign(1, last - first) * self.step_size_, low, high), 5)
        if upright:
            self.y_ = moved
        else:
            self.x_, self.y_ = moved, round(self.m_ * moved + self.b_, 5)
        if abs(last - moved) < 1e-5:  # rounding must not keep the line from ending
            self.x_, self.y_ = (self.x_, last) if upright else (last, self.y_)

    def getX(self) -> float:
        """X of the current point."""
        return self.x_

    def getY(self) -> float:
        """Y of the current point."""
        return self.y_

    def getX0(self) -> float:
        """X of the first point."""
        return self.x0_

    def getY0(self) -> float:
        """Y of the first point."""
        return self.y0_

    def getX1(self) -> float:
        """X of the last point."""
        return self.x1_

    def getY1(self) -> float:
        """Y of the last point."""
        return self.y1_

    def get_line_length(self) -> complex:
        """The length of the line; a complex number, as in nav2."""
        return complex(math.hypot(self.x1_ - self.x0_, self.y1_ - self.y0_))

    def clamp(self, n: float, min_n: float, max_n: float) -> float:
        """The number, limited to the bounds."""
        return max(min_n, min(n, max_n))
