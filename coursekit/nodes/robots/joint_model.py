"""The joints that joint_state_publisher moves: free joints, followers, and their limits."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from coursekit.nodes.robots.joint_sources import joints_of
from coursekit.urdf import Joint


@dataclass
class FreeJoint:
    """A joint with a position of its own; values that are None are not published."""

    name: str
    least: float
    greatest: float
    zero: float
    position: float | None = None
    velocity: float | None = None
    effort: float | None = None
    continuous: bool = False
    forward: bool = True

    def step(self, delta: float) -> None:
        """Move by `delta`: back and forth, or round and round for a continuous joint."""
        if self.position is None:
            return
        self.position += delta if self.forward else -delta
        if self.forward and self.position > self.greatest:
            self.position = self.least if self.continuous else self.greatest
            self.forward = self.continuous
        elif not self.forward and self.position < self.least:
            self.position, self.forward = self.least, True


@dataclass(frozen=True)
class Follower:
    """A joint that follows another: factor * its position + offset."""

    parent: str
    factor: float = 1.0
    offset: float = 0.0


@dataclass
class JointModel:
    """All joints that move, in the order of the description."""

    names: list[str] = field(default_factory=list)
    free: dict[str, FreeJoint] = field(default_factory=dict)
    followers: dict[str, Follower] = field(default_factory=dict)

    def resolve(self, name: str) -> tuple[FreeJoint, float, float] | None:
        """The free joint behind a joint, with factor and offset; None if there is none.

        Raises ValueError for joints that follow each other in a cycle.
        """
        way, factor, offset = [name], 1.0, 0.0
        while name in self.followers:
            follower = self.followers[name]
            offset += factor * follower.offset
            factor *= follower.factor
            name = follower.parent
            if name in way:
                raise ValueError(f"Found an infinite recursive mimic chain: {[*way, name]}")
            way.append(name)
        joint = self.free.get(name)
        return None if joint is None else (joint, factor, offset)


@dataclass(frozen=True)
class Options:
    """The parameters that the model depends on."""

    zeros: Mapping[str, float]
    dependent: Mapping[str, Follower]
    mimic_tags: bool = True
    smallest_limits: bool = True
    positions: bool = True
    velocities: bool = False
    efforts: bool = False


def read(description: str, options: Options) -> JointModel:
    """The joints of a description; raises UrdfError."""
    model = JointModel(followers=dict(options.dependent))
    for joint in joints_of(description):
        if not joint.moves:
            continue
        model.names.append(joint.name)
        if joint.name in options.dependent:
            continue
        if options.mimic_tags and joint.mimic is not None:
            mimic = joint.mimic
            model.followers[joint.name] = Follower(mimic.joint, mimic.multiplier, mimic.offset)
        else:
            model.free[joint.name] = _free(joint, options)
    return model


def _free(joint: Joint, options: Options) -> FreeJoint:
    least, greatest = _limits(joint, options.smallest_limits)
    zero = options.zeros.get(joint.name)
    if zero is None:
        zero = (least + greatest) / 2 if least > 0 or greatest < 0 else 0.0
    return FreeJoint(
        joint.name,
        least,
        greatest,
        zero,
        zero if options.positions else None,
        0.0 if options.velocities else None,
        0.0 if options.efforts else None,
        joint.type == "continuous",
    )


def _limits(joint: Joint, smallest: bool) -> tuple[float, float]:
    if joint.type == "continuous":
        least, greatest = -math.pi, math.pi
    else:
        assert joint.limit is not None
        least, greatest = joint.limit.lower, joint.limit.upper
    if smallest and joint.safety is not None and joint.safety.lower < joint.safety.upper:
        least, greatest = max(least, joint.safety.lower), min(greatest, joint.safety.upper)
    return least, greatest


def followers(parameters: Mapping[str, Any]) -> dict[str, Follower]:
    """The parameters below `dependent_joints`, such as {'head.parent': 'neck', 'head.factor': 2.0}; raises ValueError.

    >>> followers({"head.parent": "neck", "head.factor": 2.0})
    {'head': Follower(parent='neck', factor=2.0, offset=0.0)}
    """
    entries: dict[str, dict[str, Any]] = {}
    for name, value in parameters.items():
        joint, _, key = name.partition(".")
        if not key or "." in key:
            raise ValueError(f"Invalid dependent_joint name '{name}'")
        if key not in ("parent", "factor", "offset"):
            raise ValueError(
                f"Invalid dependent_joint name '{key}' (allowed values are 'parent', 'factor', 'offset')"
            )
        entries.setdefault(joint, {})[key] = value
    if any("parent" not in element for element in entries.values()):
        raise ValueError("All dependent_joints must at least have a parent")
    return {
        name: Follower(entry["parent"], entry.get("factor", 1.0), entry.get("offset", 0.0))
        for name, entry in entries.items()
    }
