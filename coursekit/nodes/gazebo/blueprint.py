"""A model of a file, URDF or SDF, before it becomes a robot or a thing."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from coursekit.geometry.plane import Array
from coursekit.sim.motors import Reach
from coursekit.sim.parts import Part
from coursekit.urdf import Robot
from coursekit.urdf.xml_tree import Element

from .looks import PLAIN, Look


@dataclass
class BlueLink:
    """A link: where it is in the model, what bumps, what it weighs, its sensors."""

    name: str
    pose: Array
    parts: list[Part] = field(default_factory=list)
    mass: float = 0.0
    sensors: list[Element] = field(default_factory=list)


@dataclass
class Blueprint:
    """A model: links, plugins, joints that turn, and what of it is not simulated."""

    name: str
    links: dict[str, BlueLink] = field(default_factory=dict)
    joints: dict[str, str] = field(default_factory=dict)
    """Joints with their types."""
    axles: dict[str, Array] = field(default_factory=dict)
    """Where the child of each joint is in the model."""
    plugins: list[Element] = field(default_factory=list)
    static: bool = False
    notes: list[str] = field(default_factory=list)
    pose: Array = field(default_factory=lambda: np.eye(4))
    file: Path | None = None
    root: str = ""
    """The link at the model's origin."""
    text: str = ""
    """The element that it was read from, for those who need more of it."""
    robot: Robot | None = None
    """Its description, where that is URDF."""
    reach: dict[str, Reach] = field(default_factory=dict)
    """How far its joints may go."""
    look: Look = PLAIN
    """Of its first visual with a material."""
    newer: str | None = None
    """The name of the world, where the newer Gazebo reads it; None in Gazebo Classic."""
    lumped: dict[str, str] = field(default_factory=dict)
    """By link: the one that it becomes a part of in the newer Gazebo."""
    held: set[str] = field(default_factory=set)
    """Links that fixed joints hold."""
    systems: set[str] = field(default_factory=set)
    """Of the newer Gazebo: those that it loads."""

    def note(self, element: Element, what: str) -> None:
        """List something that is not simulated, with its place."""
        place = f"{element.file}:{element.line}: " if element.file else f"line {element.line}: "
        self.notes.append(f"{place}{element.label()} {what}")

    def parts(self) -> list[Part]:
        """All that bumps, in the model's frame."""
        return [part for link in self.links.values() for part in link.parts]

    def mass(self) -> float:
        """Its mass [kg]."""
        return math.fsum(link.mass for link in self.links.values())


__all__ = ["BlueLink", "Blueprint"]
