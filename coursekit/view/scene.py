"""A scene: things with shapes at poses, and its changes since they were last sent."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from .scene_shapes import Label, Picture, Shape, rotation

Pose = tuple[float, float, float, float, float, float, float]
"""x, y, z [m] and a unit quaternion x, y, z, w"""
Scale = tuple[float, float, float]
Key = tuple[str, str]
"""(the thing's display, its own name)"""
HERE: Pose = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
FULL: Scale = (1.0, 1.0, 1.0)
_CLOSE = 1e-7
_REMEMBERED = 2000
"""The minimum number of removed things whose numbers are remembered: a page may report a click on a replaced thing."""


@dataclass
class Thing:
    """Shapes that move as one."""

    number: int
    shapes: tuple[Shape, ...]
    pose: Pose = HERE
    scale: Scale = FULL
    solid: str = ""
    """The robot that the thing is part of, which gets a soft shadow on the floor; '' for none"""


@dataclass
class Changes:
    """The steps that bring the browser's scene up to date, in this order."""

    gone: list[int] = field(default_factory=list)
    made: list[Thing] = field(default_factory=list)
    moved: list[Thing] = field(default_factory=list)

    def __bool__(self) -> bool:
        return bool(self.gone or self.made or self.moved)


class Scene:
    """Things by (display, name).

    >>> scene = Scene()
    >>> scene.put("tf", "laser", Label("laser"))
    >>> len(scene.changes().made), bool(scene.changes())
    (1, False)
    >>> scene.place("tf", "laser", (1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0))
    >>> len(scene.changes().moved)
    1
    """

    def __init__(self) -> None:
        self.things: dict[Key, Thing] = {}
        self._count = 0
        self._keys: dict[int, Key] = {}
        self._gone: list[int] = []
        self._made: dict[int, Thing] = {}
        self._moved: dict[int, Thing] = {}

    def put(
        self, display: str, name: str, *shapes: Shape, pose: Pose | None = None, scale: Scale = FULL, solid: str = ""
    ) -> None:
        """Set a thing's shapes, replacing earlier ones; `pose` is in the fixed frame."""
        old = self.things.get((display, name))
        if old is None or not _replaces(shapes, old.shapes):
            if old is not None:
                self._forget(old)
            self._count += 1
            number = self._count
            self._remember(number, (display, name))
        else:
            number = old.number
            self._moved.pop(number, None)
        thing = Thing(number, shapes, pose or (old.pose if old is not None else HERE), scale, solid)
        self.things[display, name] = self._made[thing.number] = thing

    def place(self, display: str, name: str, pose: Pose, scale: Scale = FULL) -> None:
        """Move an existing thing."""
        thing = self.things[display, name]
        if thing.scale == scale and all(abs(a - b) < _CLOSE for a, b in zip(thing.pose, pose, strict=True)):
            return
        thing.pose, thing.scale = pose, scale
        if thing.number not in self._made:
            self._moved[thing.number] = thing

    def _remember(self, number: int, key: Key) -> None:
        self._keys[number] = key
        if len(self._keys) > 2 * (len(self.things) + _REMEMBERED):
            kept = {thing.number for thing in self.things.values()} | set(list(self._keys)[-_REMEMBERED:])
            self._keys = {old: of for old, of in self._keys.items() if old in kept}

    def key_of(self, number: int) -> Key | None:
        """Return the key of the thing that has the number, or had it until replaced; None if unknown.

        >>> scene = Scene()
        >>> scene.put("scan", "dots", Label("old"))
        >>> scene.put("scan", "dots", Label("new"))
        >>> scene.key_of(1), scene.key_of(7)
        (('scan', 'dots'), None)
        """
        return self._keys.get(number)

    def has(self, display: str, name: str) -> bool:
        """Whether a thing exists."""
        return (display, name) in self.things

    def remove(self, display: str, name: str) -> None:
        """Remove a thing; does nothing if it does not exist."""
        thing = self.things.pop((display, name), None)
        if thing is not None:
            self._forget(thing)

    def clear(self, display: str) -> None:
        """Remove all things of a display."""
        for key in [key for key in self.things if key[0] == display]:
            self.remove(*key)

    def keep_only(self, display: str, names: Sequence[str] | set[str]) -> None:
        """Remove the things of a display that are not in `names`."""
        for key in [key for key in self.things if key[0] == display and key[1] not in names]:
            self.remove(*key)

    def _forget(self, thing: Thing) -> None:
        self._moved.pop(thing.number, None)
        if self._made.pop(thing.number, None) is None:
            self._gone.append(thing.number)

    def changes(self) -> Changes:
        """Return the changes since the last call."""
        changes = Changes(self._gone, list(self._made.values()), list(self._moved.values()))
        self._gone, self._made, self._moved = [], {}, {}
        return changes

    def whole(self) -> Changes:
        """Return the whole scene, for a page that shows nothing yet."""
        self.changes()
        return Changes([], list(self.things.values()), [])

    def bounds(self, displays: Sequence[str] | None = None) -> tuple[np.ndarray, np.ndarray] | None:
        """Return the minimum and maximum corner of the bounding box [m]; None for an empty scene."""
        things = [thing for key, thing in self.things.items() if displays is None or key[0] in displays]
        corners = [corner for thing in things for corner in _corners(thing)]
        return (np.min(corners, axis=0), np.max(corners, axis=0)) if corners else None


def _replaces(shapes: Sequence[Shape], old: Sequence[Shape]) -> bool:
    """Whether the page can change the old shapes into these: it keeps a picture until the next one is loaded."""
    return len(shapes) == len(old) and all(isinstance(shape, Picture) for shape in (*shapes, *old))


def _corners(thing: Thing) -> Iterator[np.ndarray]:
    turn = rotation(np.array(thing.pose[3:]))
    for shape in thing.shapes:
        if isinstance(shape, Label):
            points = np.zeros((1, 3))
        elif isinstance(shape, Picture):
            points = np.array([[0.0, 0.0, 0.0], [shape.width, shape.height, 0.0]])
        else:
            points = shape.points if not hasattr(shape, "vertices") else shape.vertices
        if len(points):
            yield from (points * thing.scale) @ turn.T + thing.pose[:3]


__all__ = ["FULL", "HERE", "Changes", "Key", "Pose", "Scale", "Scene", "Thing"]
