"""A relative pose, and causes of a wrong one."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from typing import Any

from coursekit.grade.chapters.measures.reports import Spot
from coursekit.grade.plain import close, near
from coursekit.grade.verdict import Wrong


def judge_seen(got: tuple[float, ...], me: Sequence[float], other: Sequence[float], told: str) -> None:
    """Raise Wrong unless `got` is the pose of `other` relative to `me`, as x, y and yaw."""
    x, y, yaw = got
    wanted = relative(me, other)
    answer, right = (f"({a:.3f}, {b:.3f}, {c:.3f})" for a, b, c in (got, wanted))
    if not close((x, y), wanted[:2], 1e-6):
        raise Wrong(f"{right} from {told}", gave=answer, cause=_slip((x, y), me, other), hint=1)
    if not near(math.remainder(yaw - wanted[2], math.tau), 0.0, 1e-6):
        cause = "How much does the other look further to the left than I?"
        raise Wrong(f"{right} from {told}", gave=answer, cause=cause, share=0.5, hint=2)
    if not abs(yaw) <= math.pi + 1e-9:
        cause = "A full turn changes nothing."
        raise Wrong(f"a yaw between -pi and pi from {told}", gave=f"{yaw:.3f}", cause=cause, share=0.75, hint=2)


def relative(me: Sequence[float], other: Sequence[float]) -> Spot:
    """Return the pose of `other` relative to `me`.

    >>> [round(part, 3) + 0.0 for part in relative((1.0, 1.0, math.pi / 2), (1.0, 3.0, 0.0))]  # ahead of me, looking right
    [2.0, 0.0, -1.571]
    """
    from coursekit.tf import compose, inverse

    def pose(place: Sequence[float]) -> Any:
        return (place[0], place[1], 0.0, 0.0, 0.0, math.sin(place[2] / 2), math.cos(place[2] / 2))

    x, y, _, _, _, turn, cosine = compose(inverse(pose(me)), pose(other))
    return x, y, math.remainder(2 * math.atan2(turn, cosine), math.tau)


def _slip(got: tuple[float, float], me: Sequence[float], other: Sequence[float]) -> str:
    shift = complex(other[0] - me[0], other[1] - me[1])
    for cause, value in (
        ("My yaw is not used: these are still the common frame's axes.", shift),
        ("Turned by my yaw, but in the wrong direction.", shift * cmath.rect(1.0, me[2])),
        ("Yaws are in radians already, as sin and cos take them.", shift * cmath.rect(1.0, -math.radians(me[2]))),
        ("The other minus me, not me minus the other.", -shift * cmath.rect(1.0, -me[2])),
    ):
        if abs(complex(*got) - value) < 1e-6:
            return cause
    return "Draw it: where is ahead of me, where is my left?"
