"""Checks whether a link's inertia is physically possible, and compares it with that of its shape."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from .errors import MeshError
from .model import Box, Cylinder, Geometry, Inertial, Link, Robot, Sphere
from .shapes import matrix_of, mesh_of

FAR = 10.0
"""Factor by which a moment may differ from the shape's before it is reported."""


@dataclass(frozen=True)
class Finding:
    """A finding about a link; `wrong` if it is physically impossible, else it is only unlikely."""

    link: str
    text: str
    wrong: bool

    def __str__(self) -> str:
        return f"{'wrong' if self.wrong else 'odd'}: {self.link}: {self.text}"


def matrix(inertial: Inertial) -> np.ndarray:
    """Return the inertia about the centre of mass as a symmetric 3x3 matrix [kg m^2].

    >>> matrix(Inertial(2.0, (1.0, 0.1, 0.0, 1.0, 0.0, 2.0))).tolist()
    [[1.0, 0.1, 0.0], [0.1, 1.0, 0.0], [0.0, 0.0, 2.0]]
    """
    ixx, ixy, ixz, iyy, iyz, izz = inertial.inertia
    return np.array([[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]])


def principal(inertial: Inertial) -> np.ndarray:
    """Return the three principal moments, ascending [kg m^2].

    >>> principal(Inertial(2.0, (1.0, 0.5, 0.0, 1.0, 0.0, 2.0))).round(6).tolist()
    [0.5, 1.5, 2.0]
    """
    return np.linalg.eigvalsh(matrix(inertial))


def of_shape(geometry: Geometry, mass: float, near: Path | None = None) -> np.ndarray:
    """Return the inertia (3x3) [kg m^2] of a shape with uniform density and `mass` [kg], about its centre of mass.

    >>> of_shape(Box((1.0, 1.0, 1.0)), 6.0).diagonal().tolist()
    [1.0, 1.0, 1.0]
    """
    if isinstance(geometry, Box):
        x, y, z = (edge * edge for edge in geometry.size)
        return np.diag([y + z, x + z, x + y]) * (mass / 12.0)
    if isinstance(geometry, Sphere):
        return np.eye(3) * (0.4 * mass * geometry.radius**2)
    if isinstance(geometry, Cylinder):
        across = mass * (3.0 * geometry.radius**2 + geometry.length**2) / 12.0
        return np.diag([across, across, mass * geometry.radius**2 / 2.0])
    mesh = mesh_of(geometry, near)
    body = mesh if mesh.is_volume and mesh.volume > 0 else mesh.convex_hull
    return np.asarray(body.moment_inertia) * (mass / body.volume)


def check_link(link: Link, near: Path | None = None) -> list[Finding]:
    """Return the findings about a link's mass and inertia; empty if all is well.

    >>> from coursekit.urdf.model import Inertial
    >>> (finding,) = check_link(Link("rod", inertial=Inertial(1.0, (0.1, 0.0, 0.0, 0.1, 0.0, 0.5))))
    >>> finding.wrong, finding.text.partition(":")[0]
    (True, 'no body has the principal moments (0.1, 0.1, 0.5) kg m^2')
    """
    inertial = link.inertial
    if inertial is None:
        return []
    moments = principal(inertial)
    if inertial.mass == 0.0:
        return [Finding(link.name, "its mass is 0: simulators cannot move it", False)]
    if moments[0] <= 0.0:
        text = f"its inertia is not positive definite: principal moments {_written(moments)} kg m^2"
        return [Finding(link.name, text, True)]
    if moments[0] + moments[1] < moments[2] * (1.0 - 1e-6):
        text = (
            f"no body has the principal moments {_written(moments)} kg m^2: "
            "the two smaller ones add up to at least the largest (triangle inequality)"
        )
        return [Finding(link.name, text, True)]
    return _against_shape(link, moments, near)


def _against_shape(link: Link, moments: np.ndarray, near: Path | None) -> list[Finding]:
    parts = link.collisions or link.visuals
    assert link.inertial is not None
    if len(parts) != 1:
        return []
    own = np.linalg.eigvalsh(of_shape(parts[0].geometry, link.inertial.mass, near))
    ratio = float(np.max(np.maximum(moments / own, own / moments))) if own[0] > 0 else 1.0
    if ratio < FAR:
        return []
    text = (
        f"its shape filled with {link.inertial.mass:g} kg has the principal moments {_written(own)} kg m^2, "
        f"it is given {_written(moments)}: {ratio:.0f} times off"
    )
    return [Finding(link.name, text, False)]


def check(robot: Robot) -> list[Finding]:
    """Return the findings about the masses and inertias of a robot, link by link.

    ROS 2 itself does not check them; in Gazebo such a robot trembles or flies away.
    """
    return [finding for _, link in robot.walk() for finding in _seen(link, robot.file)]


def _seen(link: Link, near: Path | None) -> list[Finding]:
    """Return the findings about a link; an unreadable mesh is one."""
    try:
        return check_link(link, near)
    except MeshError as error:
        return [Finding(link.name, f"its mass cannot be compared with its shape: {error.what}", False)]


def centre_of_mass(link: Link) -> np.ndarray:
    """Return the centre of mass in a link's frame [m]; the origin if the link has no mass."""
    return matrix_of(link.inertial.origin)[:3, 3] if link.inertial is not None else np.zeros(3)


def _written(values: np.ndarray) -> str:
    return "(" + ", ".join(f"{value:.3g}" for value in values) + ")"


__all__ = ["Finding", "centre_of_mass", "check", "check_link", "matrix", "of_shape", "principal"]
