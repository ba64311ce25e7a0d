"""A model from a file, URDF or SDF, before conversion to a robot or a thing."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from coursekit.geometry.plane import Array
from coursekit.sim.motors import Reach
from coursekit.sim.solids import Part
from coursekit.urdf import Robot
from coursekit.urdf.xml_tree import Element

from .model_colors import PLAIN, Look


@dataclass
class ModelLink:
    """A link: its pose in the model, collision parts, mass and sensors."""

    name: str
    pose: Array
    parts: list[Part] = field(default_factory=list)
    mass: float = 0.0
    sensors: list[Element] = field(default_factory=list)


@dataclass
class ModelFile:
    """A model: links, plugins, rotating joints, and notes on what is not simulated."""

    name: str
    links: dict[str, ModelLink] = field(default_factory=dict)
    joints: dict[str, str] = field(default_factory=dict)
    """Joints with their types."""
    axles: dict[str, Array] = field(default_factory=dict)
    """The pose of each joint's child in the model."""
    plugins: list[Element] = field(default_factory=list)
    static: bool = False
    notes: list[str] = field(default_factory=list)
    pose: Array = field(default_factory=lambda: np.eye(4))
    file: Path | None = None
    root: str = ""
    """The link at the model's origin."""
    text: str = ""
    """The source element, for further details."""
    robot: Robot | None = None
    """Its description, if it is URDF."""
    reach: dict[str, Reach] = field(default_factory=dict)
    """The limits of its joints."""
    look: Look = PLAIN
    """The look of its first visual with a material."""
    newer: str | None = None
    """The name of the newer Gazebo's world; None in Gazebo Classic."""
    lumped: dict[str, str] = field(default_factory=dict)
    """By link: the link into which the newer Gazebo merges it."""
    held: set[str] = field(default_factory=set)
    """Links held by fixed joints."""
    systems: set[str] = field(default_factory=set)
    """The systems of the newer Gazebo that it loads."""

    def note(self, element: Element, what: str) -> None:
        """Note an element that is not simulated, with its position."""
        place = f"{element.file}:{element.line}: " if element.file else f"line {element.line}: "
        self.notes.append(f"{place}{element.label()} {what}")

    def parts(self) -> list[Part]:
        """Return all collision parts in the model's frame."""
        return [part for link in self.links.values() for part in link.parts]

    def mass(self) -> float:
        """Return its mass [kg]."""
        return math.fsum(link.mass for link in self.links.values())


__all__ = ["ModelFile", "ModelLink"]
