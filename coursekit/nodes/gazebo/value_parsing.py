"""Parse numbers and poses in Gazebo's files."""

from __future__ import annotations

import math

import numpy as np

from coursekit.geometry.plane import Array
from coursekit.urdf.model import Origin
from coursekit.urdf.shapes import matrix_of
from coursekit.urdf.xml_tree import Element


def numbers(element: Element, count: int) -> list[float]:
    """Return the numbers in an element's text. Raises UrdfError with the position."""
    words = element.text.split()
    try:
        numbers = [float(word) for word in words]
    except ValueError:
        numbers = []
    if len(numbers) != count or not all(math.isfinite(number) for number in numbers):
        what = f"'{element.text.strip()}' is not {count} finite number{'s' if count > 1 else ''}"
        raise element.error(what, "Write numbers with spaces between them.")
    return numbers


def number(element: Element | None, path: str, default: float) -> float:
    """Return the number of a descendant ('ray/range/min'), or the default if there is none."""
    place: Element | None = element
    for tag in path.split("/"):
        place = place.first(tag) if place is not None else None
    return default if place is None or not place.text.strip() else numbers(place, 1)[0]


def flag(element: Element, tag: str, default: bool) -> bool:
    """Whether a child element is true."""
    text = element.tell(tag).lower()
    return text in ("true", "1") if text else default


def pose(element: Element | None) -> Array:
    """Return the 4x4 matrix of an element's `<pose>`, or the identity if it has none."""
    place = element.first("pose") if element is not None else None
    if place is None or not place.text.strip():
        return np.eye(4)
    return pose_of(place)


def pose_of(place: Element) -> Array:
    """Return the 4x4 matrix of a `<pose>`, in radians, or in degrees with degrees="true"."""
    if place.get("rotation_format") == "quat_xyzw":
        x, y, z, qx, qy, qz, qw = numbers(place, 7)
        return matrix((x, y, z, qx, qy, qz, qw))
    x, y, z, roll, pitch, yaw = numbers(place, 6)
    if place.get("degrees") in ("true", "1"):
        roll, pitch, yaw = map(math.radians, (roll, pitch, yaw))
    return np.asarray(matrix_of(Origin((x, y, z), (roll, pitch, yaw))))


def matrix(pose7: tuple[float, float, float, float, float, float, float]) -> Array:
    """Return x, y, z and a quaternion x, y, z, w as a 4x4 matrix."""
    px, py, pz, x, y, z, w = pose7
    size = math.sqrt(x * x + y * y + z * z + w * w) or 1.0
    x, y, z, w = x / size, y / size, z / size, (w / size if (x or y or z or w) else 1.0)
    matrix = np.eye(4)
    matrix[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    matrix[:3, 3] = px, py, pz
    return matrix


def yaw_of(made: Array) -> float:
    """Return the yaw of a 4x4 matrix."""
    return math.atan2(made[1, 0], made[0, 0])


__all__ = ["flag", "matrix", "number", "numbers", "pose", "pose_of", "yaw_of"]
