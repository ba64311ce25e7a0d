"""Things that no judge may take for an answer: beside each kind of number, text and container those that lie about it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np


class LyingFloat(float):
    """Equals, and is less and more than, whatever it is compared with; so the others."""

    def _yes(self, other: object) -> bool:
        return True

    def _itself(self, *_: object) -> Any:
        return self

    __eq__ = __lt__ = __le__ = __gt__ = __ge__ = _yes  # type: ignore[assignment]
    __sub__ = __rsub__ = __add__ = __radd__ = __abs__ = __mul__ = __rmul__ = __float__ = _itself  # type: ignore[assignment]
    __hash__ = float.__hash__


class LyingStr(str):
    """See LyingFloat."""

    __eq__ = __lt__ = __le__ = __gt__ = __ge__ = __contains__ = LyingFloat._yes  # type: ignore[assignment]
    __hash__ = str.__hash__

    def __ne__(self, other: object) -> bool:
        return False


class LyingList(list):  # type: ignore[type-arg]
    """See LyingFloat."""

    __eq__ = __lt__ = __le__ = __gt__ = __ge__ = __contains__ = LyingFloat._yes  # type: ignore[assignment]
    __hash__ = None  # type: ignore[assignment]

    def __ne__(self, other: object) -> bool:
        return False


class LyingDict(dict):  # type: ignore[type-arg]
    """See LyingFloat; it has every key."""

    __eq__ = __contains__ = LyingFloat._yes  # type: ignore[assignment]
    __hash__ = None  # type: ignore[assignment]

    def __ne__(self, other: object) -> bool:
        return False

    def __missing__(self, key: object) -> Any:
        return LyingFloat(0)


class Unshowable:
    """Its repr fails, and so does everything that is asked of it."""

    def __repr__(self) -> str:
        raise RuntimeError("no repr")

    def __getattr__(self, name: str) -> Any:
        raise RuntimeError(f"no {name}")


def endless() -> Iterator[float]:
    """Numbers without an end."""
    while True:
        yield 0.0


SCALARS: list[Any] = [
    math.nan, math.inf, -math.inf, True, False, None, 10**400, -(10**400), 10**5000, "", "x", "nan", b"", 1j, Ellipsis,
    np.float64("nan"), np.float64("inf"), np.bool_(True), np.array(math.nan), LyingFloat(0.0), LyingFloat("nan"),
    LyingStr("x"), object(), Unshowable(), type, len,
]  # fmt: skip


def containers() -> list[Any]:
    """Made anew: some of them are used up."""
    deep: list[Any] = []
    for _ in range(500):
        deep = [deep]
    return [
        [], (), {}, set(), [[]], [()], deep, endless(), LyingList([0.0, 0.0, 0.0]), LyingDict(), range(10**9),
        np.array([]), np.array([math.nan] * 3), np.array([[math.nan] * 2] * 3), np.array([None, None, None]),
    ]  # fmt: skip


def values() -> list[Any]:
    """All of them, and each scalar in pairs, triples, and lists of these."""
    many = [
        shape
        for scalar in SCALARS
        for shape in ([scalar] * 2, (scalar, scalar), (scalar, scalar, scalar), [(scalar, scalar)], [(scalar,) * 3] * 3)
    ]
    return [*SCALARS, *containers(), *many]
