"""A wheel of the rdk_x3_robot, about y, as its joint turns."""

from __future__ import annotations

import math

from trimesh import Trimesh

from .pieces import box, hull, joined, moved, rod, turned, turned_profile

WHEEL_RADIUS, WHEEL_WIDTH = 0.0375, 0.032


def tyre() -> Trimesh:
    """The rubber, with treads."""
    r, w = WHEEL_RADIUS - 0.0016, WHEEL_WIDTH / 2
    inner = 0.026
    profile = [(inner, -w), (r - 0.004, -w), (r, -w + 0.004), (r, w - 0.004), (r - 0.004, w), (inner, w), (inner, -w)]
    parts = [turned_profile(profile, 36)]
    for number in range(18):
        for side in (-1, 1):
            tread = moved(box(0.0036, 0.0045, WHEEL_WIDTH * 0.44), x=WHEEL_RADIUS - 0.0018, z=side * WHEEL_WIDTH * 0.23)
            tread = turned(tread, side * 0.35, (1, 0, 0))
            parts.append(turned(tread, math.tau * (number + (side > 0) / 2) / 18, (0, 0, 1)))
    return turned(joined(*parts), -math.pi / 2, (1, 0, 0))


def hub() -> Trimesh:
    """The rim with five spokes on either side, and the motor in the middle."""
    w = WHEEL_WIDTH / 2
    rim = turned_profile([(0.0232, -w), (0.0262, -w), (0.0262, w), (0.0232, w), (0.0232, -w)], 36)
    motor = turned_profile(
        [(0, -w + 0.002), (0.009, -w + 0.002), (0.011, -w + 0.005), (0.011, w - 0.005), (0.009, w - 0.002), (0, w - 0.002)],
        24,
    )
    parts = [rim, motor]
    for number in range(5):
        spoke = hull(
            (x, y, z)
            for x, half in ((0.009, 0.0045), (0.0245, 0.003))
            for y in (-half, half)
            for z in (-w + 0.005, w - 0.005)
        )
        parts.append(turned(spoke, math.tau * number / 5, (0, 0, 1)))
    for number in range(5):
        bolt = moved(rod(0.0016, WHEEL_WIDTH - 0.001, 8), x=0.0065)
        parts.append(turned(bolt, math.tau * (number + 0.5) / 5, (0, 0, 1)))
    return turned(joined(*parts), -math.pi / 2, (1, 0, 0))
