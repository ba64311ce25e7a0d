"""Angles and the way from one to another.

In ROS 2: the Python module of the package angles.
"""

from __future__ import annotations

from math import fmod, pi

__all__ = [
    "normalize_angle",
    "normalize_angle_positive",
    "shortest_angular_distance",
    "shortest_angular_distance_with_limits",
    "two_pi_complement",
]
_TURN = 2.0 * pi


def normalize_angle_positive(angle: float) -> float:
    """The same direction within 0 … 2π.

    >>> round(normalize_angle_positive(-1.0), 3)
    5.283
    """
    return fmod(fmod(angle, _TURN) + _TURN, _TURN)


def normalize_angle(angle: float) -> float:
    """The same direction within -π … π.

    >>> round(normalize_angle(4.0), 3)
    -2.283
    """
    made = normalize_angle_positive(angle)
    return made - _TURN if made > pi else made


def shortest_angular_distance(from_angle: float, to_angle: float) -> float:
    """By how much to turn from one angle to another, the short way: -π … π.

    >>> round(shortest_angular_distance(3.0, -3.0), 3)
    0.283
    """
    return normalize_angle(to_angle - from_angle)


def two_pi_complement(angle: float) -> float:
    """The same direction the other way round.

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
    """The turn that stays between two limits within -π … π, and whether there is one.

    >>> shortest_angular_distance_with_limits(-2.5, 2.5, -3.0, 3.0)
    (True, 5.0)
    """
    start = normalize_angle(from_angle)
    end = normalize_angle(to_angle)
    turn = shortest_angular_distance(start, end)
    if not (_inside(start, left_limit, right_limit) and _inside(end, left_limit, right_limit)):
        return False, turn
    for way in (turn, two_pi_complement(turn)):
        if _stays(start, way, left_limit, right_limit):
            return True, way
    return False, turn


def _inside(angle: float, left: float, right: float) -> bool:
    """Whether an angle lies on the way from the left limit up to the right one."""
    return normalize_angle_positive(angle - left) <= normalize_angle_positive(right - left) + 1e-12


def _stays(start: float, way: float, left: float, right: float) -> bool:
    """Whether a turn passes neither limit."""
    before = normalize_angle_positive(start - left)
    return -1e-9 <= before + way <= normalize_angle_positive(right - left) + 1e-9
