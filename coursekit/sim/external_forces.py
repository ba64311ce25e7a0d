"""External forces on robots and objects."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class ExternalForce:
    """A force [N] and torque [Nm] on a named body, from `begin_ns` until `end_ns` (None: for ever).

    >>> ExternalForce("crate", 1.0, 0.0, 0.0, 0, None).finite
    True
    """

    name: str
    x: float
    y: float
    torque: float
    begin_ns: int
    end_ns: int | None
    along: bool = False
    """Whether x points along the body's heading, instead of along the world's x."""
    label: str = ""
    """The name by which it can be ended."""

    @property
    def finite(self) -> bool:
        """Whether all values are finite."""
        return all(map(math.isfinite, (self.x, self.y, self.torque)))

    def is_over(self, now_ns: int) -> bool:
        """Whether its time has passed."""
        return self.end_ns is not None and self.end_ns <= now_ns

    def work(self, body: Any) -> None:
        """Apply it to a body during the next step."""
        force = (self.x, self.y)
        if not self.along:
            c, s = math.cos(body.angle), math.sin(body.angle)
            force = (c * self.x + s * self.y, c * self.y - s * self.x)
        body.apply_force_at_local_point(force, body.center_of_gravity)
        body.torque += self.torque


__all__ = ["ExternalForce"]
