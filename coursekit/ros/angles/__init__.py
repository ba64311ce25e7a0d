"""Angles, and rotations from one angle to another.

In ROS 2: the Python module of the package angles.
"""

from __future__ import annotations

from math import fmod, pi

__all__ = [
    "normalize_angle",
    "normalize_angle_positive",
    "shortest_angular_distance",
    "shortest_angular_distance_with_large_limits",
    "shortest_angular_distance_with_limits",
    "two_pi_complement",
]
_TURN = 2.0 * pi


def normalize_angle_positive(angle: float) -> float:
    """Normalize an angle to 0 … 2π.

    >>> round(normalize_angle_positive(-1.0), 3)
    5.283
    """
    return angle % _TURN


def normalize_angle(angle: float) -> float:
    """Normalize an angle to -π … π.

    >>> round(normalize_angle(4.0), 3)
    -2.283
    """
    positive = normalize_angle_positive(angle)
    return positive - _TURN if positive > pi else positive


def shortest_angular_distance(from_angle: float, to_angle: float) -> float:
    """The shortest rotation from one angle to another, within -π … π.

    >>> round(shortest_angular_distance(3.0, -3.0), 3)
    0.283
    """
    return normalize_angle(to_angle - from_angle)


def two_pi_complement(angle: float) -> float:
    """The rotation in the opposite sense that ends in the same direction.

    >>> round(two_pi_complement(1.0), 3)
    -5.283
    """
    if angle > _TURN or angle < -_TURN:
        angle = fmod(angle, _TURN)
    if angle < 0:
        return _TURN + angle
    if angle > 0:
        return -_TURN + angle
    return _TURN


def shortest_angular_distance_with_limits(
    from_angle: float, to_angle: float, left_limit: float, right_limit: float
) -> tuple[bool, float]:
    """Whether a rotation stays between two limits within -π … π, and that rotation.

    If none does, return the rotation that exceeds the limits less.

    >>> shortest_angular_distance_with_limits(-2.5, 2.5, -3.0, 3.0)
    (True, 5.0)
    """
    turn = shortest_angular_distance(from_angle, to_angle)
    ways = (turn, two_pi_complement(turn))
    inside, least, greatest = _find_min_max_delta(from_angle, left_limit, right_limit)
    for way in ways if inside else ():
        if least <= way <= greatest:
            return True, way
    back, forth = min(ways), max(ways)
    if inside:  # the target lies beyond a limit: which limit is nearer to it?
        _, least, greatest = _find_min_max_delta(to_angle, left_limit, right_limit)
        back, forth = forth, back
    if abs(least) == abs(greatest):
        return False, min(ways[::-1], key=abs)
    return False, back if abs(least) < abs(greatest) else forth


def _find_min_max_delta(from_angle: float, left_limit: float, right_limit: float) -> tuple[bool, float, float]:
    """Whether an angle lies between the limits, and the rotations in both senses until it reaches one."""
    to_left = shortest_angular_distance(from_angle, left_limit)
    to_right = shortest_angular_distance(from_angle, right_limit)
    back, forth_to_left = sorted((to_left, two_pi_complement(to_left)))
    back_to_right, forth = sorted((to_right, two_pi_complement(to_right)))
    if to_left == 0:
        return True, 0.0, forth
    if to_right == 0:
        return True, back, 0.0
    if back <= back_to_right or forth >= forth_to_left:  # the other limit is reached first
        return (left_limit, right_limit) == (-pi, pi), back_to_right, forth_to_left
    return True, back, forth


def shortest_angular_distance_with_large_limits(
    from_angle: float, to_angle: float, left_limit: float, right_limit: float
) -> tuple[bool, float]:
    """The same for limits that may lie beyond ±π, of a multi-turn joint; the left limit is the lower one.

    >>> shortest_angular_distance_with_large_limits(0.0, 3.0, -2 * pi, 1.0)
    (True, -3.2831853071795862)
    """
    turn = shortest_angular_distance(from_angle, to_angle)
    ways = sorted((turn, two_pi_complement(turn)), key=abs)
    for way in ways if left_limit <= right_limit else ():
        if left_limit <= from_angle + way <= right_limit:
            return left_limit <= from_angle <= right_limit, way
    return False, ways[0]
