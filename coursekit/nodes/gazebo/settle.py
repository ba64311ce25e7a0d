"""Loose things come to rest: on the floor, or on what they stand on in their file."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from coursekit.sim.world import Thing

from .solids import raised

TOUCHING = 0.05
"""A thing this little above another's top [m] rests on it."""


def settled(things: list[Thing]) -> list[Thing]:
    """The same things, loose ones lowered; from the lowest on, so that stacks stay stacks."""
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
    """How high the part of another thing is that is under the middle of a thing; 0 where there is none."""
    middle = np.mean(np.concatenate([part.corners() for part in thing.parts]), axis=0)
    x, y = other.place.inverse().transform(thing.place.transform(middle[None]))[0]
    best = 0.0
    for part in other.parts:
        (x0, y0), (x1, y1) = part.corners().min(axis=0), part.corners().max(axis=0)
        if x0 <= x <= x1 and y0 <= y <= y1 and part.high <= _low(thing) + TOUCHING:
            best = max(best, part.high)
    return best


__all__ = ["settled"]
