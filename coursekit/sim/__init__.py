"""Simulated worlds as numbers in, numbers out: what stands where, what a LiDAR sees of it, how robots drive. No ROS.

    >>> from coursekit.sim import Lidar, read_world
    >>> world = read_world("world: yard\\ncircles: [{name: post, center: [2, 0], radius: 0.5, height: 1}]")
    >>> float(Lidar(beams=8).look(world.cut(0.2), world.start)[0])
    1.5
"""

from .errors import WorldError
from .lidar import Lidar
from .odometry import Drift
from .parts import Ball, Cut, Disc, Prism, Skin
from .place import Place
from .robot import Drive, Robot, RobotModel
from .simulation import Simulation
from .world import Hinge, Thing, World
from .world_file import load_world, read_world

__all__ = [
    "Ball", "Cut", "Disc", "Drift", "Drive", "Hinge", "Lidar", "Place", "Prism", "Robot", "RobotModel", "Simulation", "Skin",
    "Thing", "World", "WorldError", "load_world", "read_world",
]  # fmt: skip
