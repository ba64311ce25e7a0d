"""Settling of loose things: on the floor, or on their support in the file."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from coursekit.sim.world import Thing

from .solids import raised

TOUCHING = 0.05
"""The maximum height above another thing's top at which a thing rests on it [m]."""


def settled(things: list[Thing]) -> list[Thing]:
    """Return the things with loose ones lowered, the lowest first, which preserves stacks."""
    done = {thing.name: thing for thing in things}
    loose = [thing for thing in things if thing.mass is not None and thing.mass != math.inf]
    for thing in sorted(loose, key=_low):
        low = _low(thing)
        support = max((_top(other, thing) for other in done.values() if other.name != thing.name), default=0.0)
        done[thing.name] = replace(thing, parts=tuple(raised(part, max(support, 0.0) - low) for part in thing.parts))
    return [done[thing.name] for thing in things]


def _low(thing: Thing) -> float:
    return min(part.low for part in thing.parts)


def _top(other: Thing, thing: Thing) -> float:
    """Return the top of another thing's part below a thing's centre; 0 if there is none."""
    middle = np.mean(np.concatenate([part.corners() for part in thing.parts]), axis=0)
    x, y = other.place.inverse().transform(thing.place.transform(middle[None]))[0]
    best = 0.0
    for part in other.parts:
        (x0, y0), (x1, y1) = part.corners().min(axis=0), part.corners().max(axis=0)
        if x0 <= x <= x1 and y0 <= y <= y1 and part.high <= _low(thing) + TOUCHING:
            best = max(best, part.high)
    return best


__all__ = ["settled"]
