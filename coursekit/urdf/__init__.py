"""Robots: parsing and checking their description (URDF, xacro), the poses, shapes and masses of their links.

Numbers in, numbers out: nothing of ROS is needed here.
"""

from .errors import MeshError, UrdfError
from .model import (
    Box,
    Collision,
    Cylinder,
    Geometry,
    Inertial,
    Joint,
    Limit,
    Link,
    Material,
    Mesh,
    Mimic,
    Origin,
    Robot,
    Sphere,
    Visual,
)
from .reader import load, load_text, parse

__all__ = [
    "Box",
    "Collision",
    "Cylinder",
    "Geometry",
    "Inertial",
    "Joint",
    "Limit",
    "Link",
    "Material",
    "Mesh",
    "MeshError",
    "Mimic",
    "Origin",
    "Robot",
    "Sphere",
    "UrdfError",
    "Visual",
    "load",
    "load_text",
    "parse",
]
