"""Past states of scenes: the content of a scene at a time, and the changes between two such moments."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from .scene import Changes, Scene, Thing

Moment = Mapping[int, Thing]
"""The things of a scene at a moment, by number."""
_POSE_BYTES = 200


def moment_of(scene: Scene) -> Moment:
    """Return the current content of a scene. Shapes are shared: the scene replaces them and never modifies them."""
    return {thing.number: replace(thing) for thing in scene.things.values()}


def between(before: Moment, after: Moment) -> Changes:
    """Return the changes that turn a page from one moment into another.

    >>> from coursekit.view.scene_shapes import Label
    >>> scene = Scene()
    >>> scene.put("tf", "laser", Label("laser"))
    >>> first = moment_of(scene)
    >>> scene.place("tf", "laser", (1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0))
    >>> scene.put("tf", "camera", Label("camera"))
    >>> there = between(first, moment_of(scene))
    >>> len(there.made), len(there.moved), between(moment_of(scene), first).gone
    (1, 1, [2])
    """
    gone = [number for number in before if number not in after]
    made = [thing for number, thing in after.items() if number not in before or before[number].shapes is not thing.shapes]
    same = [thing for number, thing in after.items() if number in before and before[number].shapes is thing.shapes]
    moved = [shown for shown in same if (shown.pose, shown.scale) != (before[shown.number].pose, before[shown.number].scale)]
    return Changes(gone, made, moved)


def size_of(moment: Moment, before: Moment) -> int:
    """Return the extra memory of a moment after an earlier one [bytes]: shared shapes count once."""
    new = [
        shown for shown in moment.values() if shown.number not in before or before[shown.number].shapes is not shown.shapes
    ]
    values = [value for shown in new for shape in shown.shapes for value in vars(shape).values()]
    return _POSE_BYTES * len(moment) + sum(value.nbytes for value in values if isinstance(value, np.ndarray))


__all__ = ["Moment", "between", "moment_of", "size_of"]
