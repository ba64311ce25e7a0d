"""Simulated worlds with plain numbers in and out: objects, what a LiDAR sees of them, and driving robots. No ROS.

    >>> from coursekit.sim import Lidar, read_world
    >>> world = read_world("world: yard\\ncircles: [{name: post, center: [2, 0], radius: 0.5, height: 1}]")
    >>> float(Lidar(beams=8).look(world.cut(0.2), world.start)[0])
    1.5
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .errors import WorldError
    from .lidar import Lidar
    from .odometry import Drift
    from .robot import Drive, Robot, RobotModel
    from .simulation import Simulation
    from .solids import Ball, Cut, Disc, Prism, Skin
    from .world import Hinge, Thing, World
    from .world_file import load_world, read_world

_PARTS = {
    "errors": ["WorldError"],
    "lidar": ["Lidar"],
    "odometry": ["Drift"],
    "robot": ["Drive", "Robot", "RobotModel"],
    "simulation": ["Simulation"],
    "solids": ["Ball", "Cut", "Disc", "Prism", "Skin"],
    "world": ["Hinge", "Thing", "World"],
    "world_file": ["load_world", "read_world"],
}
_WHERE = {name: module for module, names in _PARTS.items() for name in names}

__all__ = [
    "Ball", "Cut", "Disc", "Drift", "Drive", "Hinge", "Lidar", "Prism", "Robot", "RobotModel", "Simulation", "Skin",
    "Thing", "World", "WorldError", "load_world", "read_world",
]  # fmt: skip


def __getattr__(name: str) -> Any:
    """Import a part on first use: the LiDAR's compiler alone takes a third of a second."""
    if name not in _WHERE:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f".{_WHERE[name]}", __name__), name)
