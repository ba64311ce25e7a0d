"""Rays among walls: their lengths, and causes of wrong answers."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from coursekit.grade.figures.scans import wrong_ray
from coursekit.grade.plain import called, is_infinite, near, number, shown
from coursekit.grade.verdict import Wrong

if TYPE_CHECKING:
    from coursekit.grade.work import Work

Walls = list[tuple[float, ...]]
"""Wall segments from (x1, y1) to (x2, y2) [m]."""
FAR = 12.0
"""The drawn length of a ray that hits nothing [m]."""


@dataclass(frozen=True)
class Ray:
    """A ray from (x, y) [m] in a direction [rad], with the true and the answered length [m]; infinity if it hits nothing."""

    x: float
    y: float
    angle: float
    need: float
    got: float

    @property
    def right(self) -> bool:
        """Whether the answer is correct."""
        return self.got == self.need or abs(self.got - self.need) <= 1e-6

    def end(self, distance: float) -> tuple[float, float]:
        """Return the point at a distance along the ray [m].

        >>> Ray(1.0, 2.0, 0.0, 3.0, 3.0).end(3.0)
        (4.0, 2.0)
        """
        far = max(-FAR, min(distance, FAR))
        return self.x + far * math.cos(self.angle), self.y + far * math.sin(self.angle)


class RayJudge:
    """Calls the student's `cast_ray`."""

    def __init__(self, work: Work) -> None:
        self._work, self._cast = work, work.function("cast_ray")

    def expect(
        self, need: float, given: tuple[Any, ...], told: str, cause: str = "", share: float = 0.0, hint: int | None = None
    ) -> Ray:
        """Return the ray if `given` (walls, x, y, angle, and perhaps the reach) gives `need`; otherwise raise Wrong."""
        got = called(self._cast, *given, told=f"cast_ray: {told}")
        wanted = f"{'math.inf' if math.isinf(need) else f'{need:.4g} m'} for {told}"
        x, y, angle = given[1:4]
        ray = Ray(x, y, angle, need, math.inf if is_infinite(got) else number(got, wanted, share=share))
        if not ray.right:
            self._work.illustrate(wrong_ray, given[0], ray)
            reason = _why(got, need, *given) or cause
            raise Wrong(wanted, gave=shown(got, 40), cause=reason, share=share, hint=None if reason != cause else hint)
        return ray


def _why(got: Any, need: float, walls: Walls, x: float, y: float, angle: float, reach: float = 10.0) -> str:
    if abs(angle) > 1e-9 and near(got, distance(walls, x, y, math.radians(angle), reach), 1e-6):
        return "The angle is in radians already, as sin and cos take it."
    if math.isinf(need) and near(got, reach, 1e-9):
        return "Where there is no wall within `range_max`, `math.inf` is asked for."
    return "It is further than range_max." if math.isinf(need) and not near(got, 0.0, reach) else ""


def distance(walls: Walls, x: float, y: float, angle: float, reach: float) -> float:
    """Return the range of the simulator's LiDAR in a direction [m]; infinity beyond `reach`.

    >>> wall = [(2.0, -1.0, 2.0, 1.0)]
    >>> distance(wall, 0.5, 0.0, 0.0, 5.0), distance(wall, 0.5, 0.0, 0.0, 1.0)
    (1.5, inf)
    """
    import numpy as np

    from coursekit.geometry.plane import Pose2D
    from coursekit.sim import Cut, Lidar

    lidar = Lidar(beams=1, angle_min=0.0, angle_max=0.0, range_min=0.0, range_max=50.0)
    truth = float(lidar.look(Cut(np.array(walls), np.zeros((0, 3))), Pose2D(x, y, angle))[0])
    return truth if truth <= reach else math.inf
