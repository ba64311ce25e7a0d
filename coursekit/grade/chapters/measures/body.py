"""Measurements of a robot's body: its pose, size, mass and stability."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from coursekit.grade.verdict import NO_HINT, Wrong

if TYPE_CHECKING:
    import numpy as np

    from coursekit.urdf import Robot

FLOOR = 0.002
"""The maximum gap that counts as contact with the floor [m]."""


def poses(robot: Robot, positions: dict[str, float]) -> dict[str, Any]:
    """Return each link's pose in the root frame, as x, y, z [m] and a quaternion."""
    from coursekit.urdf.kinematics import Kinematics

    return Kinematics(robot).poses(positions)


def solids(robot: Robot, positions: dict[str, float]) -> list[np.ndarray]:
    """Return the corners of all collision shapes in the root frame [m]; Wrong if there are none."""
    from coursekit.urdf.shapes import robot_surfaces

    solids = [surface.vertices for _, surface in robot_surfaces(robot, positions, collision=True)]
    if not solids:
        raise Wrong("links with <collision>", "there is none", hint=NO_HINT)
    return solids


def extent(robot: Robot, link: str, positions: dict[str, float]) -> tuple[float, ...]:
    """Return the visible length, width and height of a link along the root's axes [m]."""
    import numpy as np

    from coursekit.urdf.shapes import robot_surfaces

    parts = [surface.vertices for name, surface in robot_surfaces(robot, positions) if name == link]
    if not parts:
        raise Wrong(f"{link} with a <visual>", "it has none", share=0.25, hint=1)
    points = np.concatenate(parts)
    return tuple(float(length) for length in points.max(axis=0) - points.min(axis=0))


def centre_of_mass(robot: Robot, positions: dict[str, float]) -> np.ndarray:
    """Return the whole robot's centre of mass in the root frame [m].

    >>> from coursekit.urdf import parse
    >>> robot = parse('''<robot name="post"><link name="post"><inertial><origin xyz="0 0 0.5"/><mass value="2"/>
    ...   <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link></robot>''')
    >>> centre_of_mass(robot, {}).tolist()
    [0.0, 0.0, 0.5]
    """
    import numpy as np

    from coursekit.urdf import inertia
    from coursekit.urdf.kinematics import Kinematics

    kinematics = Kinematics(robot)
    total, moment = 0.0, np.zeros(3)
    for name, matrix in zip(kinematics.links, kinematics.matrices(positions), strict=True):
        link = robot.links[name]
        if link.inertial is not None:
            total += link.inertial.mass
            moment += link.inertial.mass * (matrix[:3, :3] @ inertia.centre_of_mass(link) + matrix[:3, 3])
    return moment / max(total, 1e-9)


def turned(pose: Any, vector: tuple[float, float, float]) -> tuple[float, float, float]:
    """Transform a direction from a link's frame to the root frame.

    >>> quarter = (0.0, 0.0, 0.0, 0.0, 0.0, 0.7071067811865476, 0.7071067811865476)
    >>> [round(part, 6) + 0.0 for part in turned(quarter, (1.0, 0.0, 0.0))]
    [0.0, 1.0, 0.0]
    """
    from coursekit.geometry.pose import compose

    x, y, z, *_ = compose((0.0, 0.0, 0.0, *pose[3:]), (*vector, 0.0, 0.0, 0.0, 1.0))
    return x, y, z


def inverse(pose: Any) -> tuple[float, ...]:
    """Return the inverse rotation."""
    return (0.0, 0.0, 0.0, -pose[3], -pose[4], -pose[5], pose[6])


def contacts(robot: Robot, positions: dict[str, float]) -> np.ndarray:
    """Return the corners (n, 2) of the shapes that touch the floor, or are as low as the lowest [m]."""
    import numpy as np

    points = np.concatenate(solids(robot, positions))
    feet: np.ndarray = points[points[:, 2] < points[:, 2].min() + FLOOR][:, :2]
    return feet


def outside(robot: Robot, positions: dict[str, float]) -> float:
    """Return how far the centre of mass is outside of the support polygon [m]; negative inside."""
    import numpy as np
    from scipy.spatial import ConvexHull, QhullError

    feet = contacts(robot, positions)
    centre = centre_of_mass(robot, positions)
    try:
        hull = ConvexHull(feet)
    except (QhullError, ValueError):
        return float(np.linalg.norm(feet - centre[:2], axis=1).min())
    return float((hull.equations[:, :2] @ centre[:2] + hull.equations[:, 2]).max())
