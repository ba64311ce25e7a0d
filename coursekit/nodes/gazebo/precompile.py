"""Load the compiled loops before the simulation starts, so that the first scan is not delayed."""

from __future__ import annotations

from functools import lru_cache

from coursekit.geometry.plane import Pose2D
from coursekit.sim import Disc, Lidar, Prism, RobotModel, Simulation, Thing, World


@lru_cache(maxsize=1)
def warm_up() -> None:
    """Run each of the LiDAR's compiled loops once."""
    block = Prism(((1.0, -1.0), (1.5, -1.0), (1.5, 1.0)))
    simulation = Simulation(World("small", (Thing("wall", (block, Disc(0.0, 3.0, 0.5))),)))
    robot = simulation.spawn(RobotModel("robot"))
    simulation.scan(Lidar(beams=8, height=0.1), robot)
    simulation.scan(Lidar(beams=90, height=0.1), None, Pose2D())


__all__ = ["warm_up"]
