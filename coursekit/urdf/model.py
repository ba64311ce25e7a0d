"""A robot as data: links, joints, shapes and materials. Lengths in metres, angles in radians, masses in kilograms."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from .errors import UrdfError, close
from .xml_tree import Element

Vector = tuple[float, float, float]
Colour = tuple[float, float, float, float]
"""Red, green, blue and opacity, from 0 to 1."""
ZERO: Vector = (0.0, 0.0, 0.0)
MOVING = ("revolute", "continuous", "prismatic")
"""Joint types with a single position value; `floating` and `planar` have more, `fixed` has none."""
JOINT_TYPES = ("fixed", "revolute", "continuous", "prismatic", "floating", "planar")


@dataclass(frozen=True)
class Origin:
    """A pose in the parent's frame: translated by `xyz`, rotated by roll, pitch and yaw (fixed axes x, y, z)."""

    xyz: Vector = ZERO
    rpy: Vector = ZERO


@dataclass(frozen=True)
class Box:
    """A block around its centre; `size` are its edge lengths."""

    size: Vector


@dataclass(frozen=True)
class Cylinder:
    """A cylinder around its centre, along z."""

    radius: float
    length: float


@dataclass(frozen=True)
class Sphere:
    """A sphere around its centre."""

    radius: float


@dataclass(frozen=True)
class Mesh:
    """A shape from a file, with `filename` as written (package://..., file://..., or a path)."""

    filename: str
    scale: Vector = (1.0, 1.0, 1.0)


Geometry = Box | Cylinder | Sphere | Mesh


@dataclass(frozen=True)
class Material:
    """A named colour or texture; both are None if only the name is known."""

    name: str
    colour: Colour | None = None
    texture: str | None = None


@dataclass(frozen=True)
class Visual:
    """The visible shape of a link."""

    geometry: Geometry
    origin: Origin = Origin()
    material: Material | None = None
    name: str = ""
    line: int = 0


@dataclass(frozen=True)
class Collision:
    """The collision shape of a link."""

    geometry: Geometry
    origin: Origin = Origin()
    name: str = ""
    line: int = 0


@dataclass(frozen=True)
class Inertial:
    """Mass, and inertia about the centre of mass at `origin` [kg, kg m^2]: ixx, ixy, ixz, iyy, iyz, izz."""

    mass: float
    inertia: tuple[float, float, float, float, float, float]
    origin: Origin = Origin()
    line: int = 0


@dataclass(frozen=True)
class Link:
    """A rigid part, with a frame of the same name."""

    name: str
    visuals: tuple[Visual, ...] = ()
    collisions: tuple[Collision, ...] = ()
    inertial: Inertial | None = None
    line: int = 0


@dataclass(frozen=True)
class Limit:
    """The position limits of a joint (rad or m), its maximum effort (Nm or N) and velocity (rad/s or m/s)."""

    lower: float = 0.0
    upper: float = 0.0
    effort: float = 0.0
    velocity: float = 0.0


@dataclass(frozen=True)
class Mimic:
    """The joint follows another: position = multiplier * position of `joint` + offset."""

    joint: str
    multiplier: float = 1.0
    offset: float = 0.0


@dataclass(frozen=True)
class Safety:
    """Soft limits for controllers."""

    k_velocity: float
    k_position: float = 0.0
    lower: float = 0.0
    upper: float = 0.0


@dataclass(frozen=True)
class Joint:
    """The connection of `child` to `parent`; `axis` has length 1."""

    name: str
    type: str
    parent: str
    child: str
    origin: Origin = Origin()
    axis: Vector = (1.0, 0.0, 0.0)
    limit: Limit | None = None
    mimic: Mimic | None = None
    safety: Safety | None = None
    damping: float = 0.0
    friction: float = 0.0
    line: int = 0

    @property
    def moves(self) -> bool:
        """Whether its position is a single number."""
        return self.type in MOVING


@dataclass(frozen=True)
class Robot:
    """A valid robot: one root, no loops, all names known."""

    name: str
    links: dict[str, Link]
    joints: dict[str, Joint]
    root: str
    materials: dict[str, Material] = field(default_factory=dict)
    gazebo: tuple[Element, ...] = ()
    """The `<gazebo>` elements, for simulators."""
    warnings: tuple[str, ...] = ()
    """Permitted content that is probably unintended, with its location."""
    faults: tuple[UrdfError, ...] = ()
    """Errors that urdfdom reports and skips: the link lacks the invalid element and all later ones."""
    file: Path | None = None
    """The file that it was read from; paths of meshes are relative to its folder."""

    def __post_init__(self) -> None:
        below: dict[str, list[Joint]] = {name: [] for name in self.links}
        for joint in self.joints.values():
            below[joint.parent].append(joint)
        object.__setattr__(self, "_below", {name: tuple(joints) for name, joints in below.items()})
        object.__setattr__(self, "_above", {joint.child: joint for joint in self.joints.values()})

    def link(self, name: str) -> Link:
        """Return a link by name; LookupError suggests similar names.

        >>> Robot("ball", {"base_link": Link("base_link")}, {}, "base_link").link("base_lnk")
        Traceback (most recent call last):
        LookupError: ball has no link 'base_lnk'. Did you mean 'base_link'?
        """
        if name not in self.links:
            raise LookupError(f"{self.name} has no link '{name}'. {close(name, self.links)}")
        return self.links[name]

    def joint(self, name: str) -> Joint:
        """Return a joint by name; LookupError suggests similar names."""
        if name not in self.joints:
            raise LookupError(f"{self.name} has no joint '{name}'. {close(name, self.joints)}")
        return self.joints[name]

    def joints_below(self, link: str) -> tuple[Joint, ...]:
        """Return the joints whose parent is this link, in file order."""
        below: dict[str, tuple[Joint, ...]] = self._below  # type: ignore[attr-defined]
        return below[self.link(link).name]

    def joint_above(self, link: str) -> Joint | None:
        """Return the joint above a link; None for the root."""
        above: dict[str, Joint] = self._above  # type: ignore[attr-defined]
        return above.get(self.link(link).name)

    def walk(self) -> Iterator[tuple[int, Link]]:
        """Yield (depth, link) from the root on, each link after its parent, branch by branch.

        >>> from coursekit.urdf import parse
        >>> robot = parse('''<robot name="mast"><link name="top"/><link name="base"/><joint name="pole" type="fixed">
        ...   <parent link="base"/><child link="top"/></joint></robot>''')
        >>> [(depth, link.name) for depth, link in robot.walk()]
        [(0, 'base'), (1, 'top')]
        """
        waiting = [(0, self.root)]
        while waiting:
            depth, name = waiting.pop()
            yield depth, self.links[name]
            waiting += [(depth + 1, joint.child) for joint in reversed(self.joints_below(name))]

    def moving_joints(self) -> list[Joint]:
        """Return the movable joints in file order, except those that mimic another.

        >>> from coursekit.urdf import parse
        >>> robot = parse('''<robot name="gripper"><link name="palm"/><link name="left"/><link name="right"/>
        ...   <joint name="finger" type="continuous"><parent link="palm"/><child link="left"/><axis xyz="0 0 1"/></joint>
        ...   <joint name="other" type="continuous"><parent link="palm"/><child link="right"/><axis xyz="0 0 1"/>
        ...   <mimic joint="finger" multiplier="-1"/></joint></robot>''')
        >>> [joint.name for joint in robot.moving_joints()]
        ['finger']
        """
        return [joint for joint in self.joints.values() if joint.moves and joint.mimic is None]


__all__ = [
    "JOINT_TYPES", "MOVING", "Box", "Collision", "Colour", "Cylinder", "Geometry", "Inertial", "Joint", "Limit", "Link",
    "Material", "Mesh", "Mimic", "Origin", "Robot", "Safety", "Sphere", "UrdfError", "Vector", "Visual",
]  # fmt: skip
