"""The body of the rdk_x3_robot, in base_link: 0.0659 m above the floor. And r2d2's finger."""

from __future__ import annotations

import math

from trimesh import Trimesh

from .pieces import block, hull, joined, moved, outline, rod, turned, turned_profile
from .wheels import WHEEL_RADIUS


def tub() -> Trimesh:
    """The lower body: motors' brackets, bumpers, belly."""
    belly = hull(
        (x, y, z)
        for z, points in (
            (-0.044, outline(0.20, 0.125, 0.012)),
            (-0.034, outline(0.236, 0.146, 0.014)),
            (-0.004, outline(0.250, 0.150, 0.016)),
        )
        for x, y in points
    )
    parts = [belly]
    for x in (-0.08, 0.08):
        axle = turned(rod(0.008, 0.166, 16), math.pi / 2, (1, 0, 0))
        parts.append(moved(axle, x=x, z=WHEEL_RADIUS - 0.0659))
    for x in (-0.132, 0.132):
        parts.append(moved(block(0.018, 0.120, 0.016, 0.007, 0.003), x=x, z=-0.018))
    return joined(*parts)


def shell() -> Trimesh:
    """The coloured upper body, lower in front, with mudguards over the wheels."""
    body = hull(
        [(x, y, -0.004) for x, y in outline(0.252, 0.152, 0.018)]
        + [(x, y, 0.010) for x, y in outline(0.246, 0.148, 0.018)]
        + [(x - 0.012, y, 0.030) for x, y in outline(0.186, 0.112, 0.016)]
    )
    parts = [body]
    for x in (-0.08, 0.08):
        for side in (-1, 1):
            guard = hull(
                [(x + dx, side * y, z) for dx, z in ((-0.045, 0.004), (-0.032, 0.0145), (0.032, 0.0145), (0.045, 0.004))
                 for y in (0.070, 0.112)]
                + [(x + dx, side * y, z) for dx, z in ((-0.045, 0.0015), (-0.032, 0.0115), (0.032, 0.0115), (0.045, 0.0015))
                   for y in (0.070, 0.112)]
            )  # fmt: skip
            parts.append(guard)
    return joined(*parts)


def deck() -> Trimesh:
    """The upper plate on its posts, the mast of the second camera and two aerials."""
    parts = [moved(block(0.196, 0.118, 0.004, 0.014, 0.0008), x=-0.008, z=0.054)]
    for x in (-0.088, 0.072):
        for y in (-0.045, 0.045):
            parts.append(moved(rod(0.0034, 0.030, 10), x=x, y=y, z=0.038))
            parts.append(moved(rod(0.0048, 0.0026, 6), x=x, y=y, z=0.057))
    mast = hull(
        (x, y, z) for z, dx in ((0.055, 0.009), (0.140, 0.006)) for x in (-0.100 - dx, -0.100 + dx) for y in (-0.008, 0.008)
    )
    parts.append(mast)
    for y in (-0.050, 0.050):
        parts.append(
            moved(
                turned_profile([(0, 0), (0.0042, 0), (0.0042, 0.012), (0.0022, 0.016), (0.0016, 0.07), (0, 0.071)], 10),
                x=-0.090,
                y=y,
                z=0.056,
            )
        )
    return joined(*parts)


def lamps() -> Trimesh:
    """Two headlamps and a light bar behind."""
    parts = []
    for y in (-0.052, 0.052):
        parts.append(moved(turned(rod(0.0085, 0.008, 20), math.pi / 2, (0, 1, 0)), x=0.1215, y=y, z=0.004))
    parts.append(moved(block(0.006, 0.090, 0.006, 0.0025, 0.001), x=-0.1245, z=0.004))
    return joined(*parts)


def finger() -> Trimesh:
    """A finger that reaches along x from the origin and bends inwards (to -y) at its end."""
    upper = hull(
        (x, y, z)
        for x, y in ((0.0, -0.012), (0.0, 0.012), (0.085, 0.030), (0.100, 0.020), (0.088, 0.006))
        for z in (-0.014, 0.014)
    )
    tip = hull(
        (x, y, z)
        for x, y in ((0.086, 0.029), (0.100, 0.020), (0.140, -0.006), (0.136, -0.014), (0.080, 0.008))
        for z in (-0.010, 0.010)
    )
    knuckle = rod(0.016, 0.034, 16)
    return joined(upper, tip, knuckle)
