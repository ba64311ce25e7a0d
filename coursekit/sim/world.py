"""A world as data: fixed objects, movable objects, and the robots' start. In m, rad and kg."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from coursekit.geometry.plane import ORIGIN, Pose2D

from .errors import WorldError, known
from .solids import Cut, Part, join
from .spherical_coordinates import SphericalCoordinates
from .walk import Walk

TEXTURES = ("plain", "brick", "concrete", "wood", "crates", "metal", "stripes", "tiles", "door", "hedge")
"""The textures of walls for a camera."""


@dataclass(frozen=True)
class Hinge:
    """A door's hinge: it is at the object's own origin and rotates between two angles relative to the initial one."""

    lower: float
    upper: float


@dataclass(frozen=True)
class Thing:
    """An object in the world. Without `mass` it is fixed; with one it can be pushed."""

    name: str
    parts: tuple[Part, ...]
    place: Pose2D = ORIGIN
    mass: float | None = None
    friction: float = 0.3
    texture: str = "plain"
    colour: tuple[float, float, float] | None = None
    hinge: Hinge | None = None
    velocity: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """Velocity of objects that move by themselves: m/s, m/s, rad/s in the world's frame; their `mass` is infinite."""
    walk: Walk | None = None
    """A walk instead of a velocity; its `mass` is infinite, too."""
    solid: bool = True
    """Whether it collides with others; sensors see it in any case."""
    model: str = ""
    """The model or element of the file that defined it."""

    @property
    def moves(self) -> bool:
        """Whether it can move."""
        return self.mass is not None

    def cut(self, height: float) -> Cut:
        """Return the outline at a height, in its own frame."""
        return join([part.cut(height) for part in self.parts])


@dataclass(frozen=True)
class World:
    """A world; the names of its objects are unique.

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
    """The names known to the user (models of a Gazebo file), with their poses, including models without collision shapes."""
    globe: SphericalCoordinates | None = None
    """Its location on the Earth; None if the file does not specify one."""
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
        """Return an object by name; LookupError suggests similar names.

        >>> from coursekit.sim import Disc
        >>> World("yard", (Thing("post", (Disc(1.0, 0.0, 0.1),)),)).thing("pots")
        Traceback (most recent call last):
        LookupError: world 'yard' has no 'pots'. Did you mean 'post'?
        """
        for thing in self.things:
            if thing.name == name:
                return thing
        raise LookupError(f"world '{self.name}' has no '{name}'. {known(name, [other.name for other in self.things])}")

    def fixed(self) -> Iterator[Thing]:
        """The fixed objects."""
        return (thing for thing in self.things if not thing.moves)

    def cut(self, height: float) -> Cut:
        """Return the outline of the fixed objects at a height [m], in the world's frame.

        >>> from coursekit.sim import Disc
        >>> yard = World("yard", (Thing("post", (Disc(0.0, 0.0, 0.1),), Pose2D(3.0, 1.0, 0.0)),))
        >>> yard.cut(0.5).circles.tolist()
        [[3.0, 1.0, 0.1]]
        """
        return join([thing.cut(height).moved(thing.place) for thing in self.fixed()])

    def bounds(self) -> tuple[float, float, float, float]:
        """Return smallest x and y, largest x and y, of all objects; zeros for an empty world.

        >>> from coursekit.sim import Disc
        >>> World("yard", (Thing("post", (Disc(1.0, 0.0, 0.5),)),)).bounds()
        (0.5, -0.5, 1.5, 0.5)
        """
        corners = [thing.place.transform(part.corners()) for thing in self.things for part in thing.parts]
        if not corners:
            return 0.0, 0.0, 0.0, 0.0
        points = np.concatenate(corners)
        (x0, y0), (x1, y1) = points.min(axis=0), points.max(axis=0)
        return float(x0), float(y0), float(x1), float(y1)


__all__ = ["TEXTURES", "Hinge", "Thing", "World"]
