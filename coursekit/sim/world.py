"""A world as data: things that stand, things that can be moved, where robots begin. In m, rad and kg."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace

import numpy as np

from coursekit.geometry.plane import ORIGIN, Pose2D

from .errors import WorldError, known
from .globe import Globe
from .parts import Cut, Part, join
from .walk import Walk

TEXTURES = ("plain", "brick", "concrete", "wood", "crates", "metal", "stripes", "tiles", "door", "hedge")
"""The looks of walls for a camera."""


@dataclass(frozen=True)
class Hinge:
    """A door's hinge: it hangs at the thing's own origin and turns between two angles from where it is."""

    lower: float
    upper: float


@dataclass(frozen=True)
class Thing:
    """Something in the world. Without `mass` it is fixed; with one it can be pushed."""

    name: str
    parts: tuple[Part, ...]
    place: Pose2D = ORIGIN
    mass: float | None = None
    friction: float = 0.3
    texture: str = "plain"
    colour: tuple[float, float, float] | None = None
    hinge: Hinge | None = None
    velocity: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """Of things that move by themselves: m/s, m/s, rad/s in the world's frame; they have `mass` infinity."""
    walk: Walk | None = None
    """Where it is at which time, in place of a velocity; its `mass` is infinity, too."""
    solid: bool = True
    """Whether others bump into it; sensors see it all the same."""
    model: str = ""
    """The model or element of the file that it came from."""

    @property
    def moves(self) -> bool:
        """Whether it can be anywhere else than where it is."""
        return self.mass is not None

    def cut(self, height: float) -> Cut:
        """Its outline at a height, in its own frame."""
        return join([part.cut(height) for part in self.parts])


@dataclass(frozen=True)
class World:
    """A world; `names` of things are unique.

    >>> from coursekit.sim import Disc
    >>> world = World("yard", (Thing("post", (Disc(1.0, 0.0, 0.1),)),))
    >>> world.thing("post").moves
    False
    """

    name: str
    things: tuple[Thing, ...] = ()
    start: Pose2D = ORIGIN
    floor: str = "tiles"
    file: str = ""
    notes: tuple[str, ...] = ()
    """The parts of the file that are not simulated, one sentence each."""
    models: dict[str, Pose2D] = field(default_factory=dict)
    """Names that a user asks for (a model of a Gazebo file), with their places, also where nothing of them can be met."""
    globe: Globe | None = None
    """Where on the Earth it lies; None where its file does not say."""
    magnetism: tuple[float, float, float] = (5.5645e-6, 22.8758e-6, -42.3884e-6)
    """The Earth's magnetic field [T], along x, y and z."""

    def __post_init__(self) -> None:
        seen: set[str] = set()
        for thing in self.things:
            if thing.name in seen:
                raise WorldError(
                    "the name is taken", file=self.file, element=f"'{thing.name}'", cure="Give each thing its own name."
                )
            seen.add(thing.name)

    def thing(self, name: str) -> Thing:
        """A thing by name; LookupError names near ones."""
        for thing in self.things:
            if thing.name == name:
                return thing
        raise LookupError(f"world '{self.name}' has no '{name}'. {known(name, [one.name for one in self.things])}")

    def fixed(self) -> Iterator[Thing]:
        """The fixed things."""
        return (thing for thing in self.things if not thing.moves)

    def movable(self) -> Iterator[Thing]:
        """The things that can be moved."""
        return (thing for thing in self.things if thing.moves)

    def cut(self, height: float) -> Cut:
        """The outline of what is fixed."""
        return join([thing.cut(height).moved(thing.place) for thing in self.fixed()])

    def bounds(self) -> tuple[float, float, float, float]:
        """Smallest x and y, largest x and y, of all things; zeros for an empty world."""
        corners = [thing.place.transform(part.corners()) for thing in self.things for part in thing.parts]
        if not corners:
            return 0.0, 0.0, 0.0, 0.0
        points = np.concatenate(corners)
        (x0, y0), (x1, y1) = points.min(axis=0), points.max(axis=0)
        return float(x0), float(y0), float(x1), float(y1)

    def with_things(self, *things: Thing) -> World:
        """The same world and some more things."""
        return replace(self, things=self.things + things)


__all__ = ["TEXTURES", "Hinge", "Thing", "World"]
