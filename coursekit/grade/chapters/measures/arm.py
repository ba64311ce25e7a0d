"""A planar arm of two parts: the position of its tip, and causes of a wrong one."""

from __future__ import annotations

import math
from collections.abc import Sequence

from coursekit.grade.plain import close


def why_tip(got: Sequence[float], shoulder: float, elbow: float) -> str:
    """Return the likely cause of a wrong tip position, for an arm of 0.4 and 0.3 m."""
    right = arm_tip(shoulder, elbow, 0.4, 0.3)
    causes = {
        "The angles are in radians already, as sin and cos take them.": arm_tip(
            math.radians(shoulder), math.radians(elbow), 0.4, 0.3
        ),
        "Is the elbow's angle alone taken for the forearm? It is measured from the upper arm.": arm_tip(
            shoulder, elbow - shoulder, 0.4, 0.3
        ),
        "The right numbers, in the other order: x first.": right[::-1],
    }
    for cause, place in causes.items():
        if close(got, place, 1e-6):
            return cause
    if close(got, right, 0.02):
        return "Nearly: is something rounded? Return the numbers as they are."
    return "Draw the arm: where is the elbow, and where does the forearm point from there?"


def arm_tip(shoulder: float, elbow: float, upper: float, fore: float) -> tuple[float, float]:
    """Return the tip's position (x, y) [m] at two angles [rad], as computed by the course's library.

    >>> [round(part, 3) + 0.0 for part in arm_tip(math.pi / 2, -math.pi / 2, 0.4, 0.3)]  # up, then ahead
    [0.3, 0.4]
    """
    from coursekit.urdf import parse
    from coursekit.urdf.kinematics import Kinematics

    links = "".join(f'<link name="l{index}"/>' for index in range(4))
    joint = '<joint name="j{0}" type="{1}"><origin xyz="{2} 0 0"/><parent link="l{0}"/><child link="l{3}"/>{4}</joint>'
    axis = '<axis xyz="0 0 1"/>'
    joints = joint.format(0, "continuous", 0, 1, axis) + joint.format(1, "continuous", upper, 2, axis)
    joints += joint.format(2, "fixed", fore, 3, "")
    x, y, *_ = Kinematics(parse(f'<robot name="arm">{links}{joints}</robot>')).poses({"j0": shoulder, "j1": elbow})["l3"]
    return x, y
