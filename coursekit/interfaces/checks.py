"""The checks that the setters of message classes apply to a value, as fast as Python allows."""

from __future__ import annotations

from collections import UserList, UserString
from collections.abc import Sequence, Set
from struct import Struct
from typing import Any

FLOAT32_MAX = 3.402823466e38
_FLOAT32 = Struct("f")
_PLAIN = (list, tuple)


def is_collection(value: object) -> bool:
    """Return whether a value is a set or a sequence other than a string.

    >>> is_collection((1, 2)), is_collection("12")
    (True, False)
    """
    if type(value) in _PLAIN:
        return True
    return isinstance(value, (Sequence, Set, UserList)) and not isinstance(value, (str, UserString))


def all_are(values: Any, kind: type) -> bool:
    """Return whether each value is of a type.

    >>> all_are([1, True], int), all_are([1, 2.0], int)
    (True, False)
    """
    for value in values:
        if type(value) is not kind:  # an exact match is the usual case: a third of the time
            return all(issubclass(value_type, kind) for value_type in set(map(type, values)))
    return True


def all_within(values: Any, low: int, high: int) -> bool:
    """Return whether each integer is in [low, high]; true for an empty collection.

    >>> all_within([0, 255], 0, 255), all_within([-1], 0, 255)
    (True, False)
    """
    return not values or (min(values) >= low and max(values) <= high)


def all_float32(values: Any) -> bool:
    """Return whether each number is a float32: within its bounds, infinite or not a number.

    >>> all_float32([0.1, float("inf")]), all_float32([1e39])
    (True, False)
    """
    return all(
        not (v < -FLOAT32_MAX or v > FLOAT32_MAX) or v in (float("inf"), float("-inf")) for v in values
    )


def float32(value: float) -> float:
    """Return the nearest float32, the value that a message carries: 0.1 is received as a slightly different number.

    >>> float32(0.1), float32(0.5)
    (0.10000000149011612, 0.5)
    """
    return _FLOAT32.unpack(_FLOAT32.pack(value))[0]  # type: ignore[no-any-return]


def all_no_longer_than(values: Any, length: int) -> bool:
    """Return whether each string has at most `length` characters.

    >>> all_no_longer_than(["map", "odom"], 3)
    False
    """
    return all(len(value) <= length for value in values)


def is_octet(value: object) -> bool:
    """Return whether a value is one byte.

    >>> is_octet(b"a"), is_octet(97)
    (True, False)
    """
    return isinstance(value, (bytes, bytearray)) and len(value) == 1
