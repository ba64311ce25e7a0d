"""The course's warehouse, driven through with drifting odometry: the map is right, and the robot knows where it is."""

import math
from pathlib import Path

import numpy as np
import pytest

from coursekit.geometry.plane import Pose2D
from coursekit.nav.map_compare import compare, outline_points
from coursekit.nav.map_file import GridMap
from coursekit.sim import Drift, Drive, Lidar, RobotModel, Simulation, load_world
from coursekit.slam.scan import Laser
from coursekit.slam.slam import Slam

WORLD = Path(__file__).resolve().parents[2] / "maps" / "worlds" / "tec_warehouse.yaml"
WAY = [
    (0, 0), (3, -0.6), (6, -1), (9, 0.4), (12.6, 0.0), (14.8, -0.9), (14.4, 2), (14, 5.6), (11, 5.2), (9, 5.6), (4, 5.7),
    (-0.8, 5.8), (-0.8, 3.2), (4, 3.2), (9.5, 3.2), (14.2, 3.0), (14.2, 6.8), (13.6, 7.7), (10.8, 8.1), (5, 8.0), (0.5, 8.3),
    (0.8, 10.3), (3.2, 10.5), (6, 10.2), (9, 10.0), (11.2, 9.6), (11.6, 8.4), (13.6, 7.7), (14.3, 3), (14.0, 0.8), (9, 0.5),
    (5.5, -0.8), (3, -0.6), (0, 0),
]  # fmt: skip
"""Along every aisle and back, around the crates."""


def pose(place):
    return Pose2D(place.x, place.y, place.theta)


class Tour:
    """A tour through the warehouse: SLAM's map and poses, and the truth."""

    def __init__(self, seed):
        self.simulation = Simulation(load_world(WORLD), seed)
        model = RobotModel("rover", drive=Drive(max_speed=0.8, max_turn=1.5), drift=Drift.usual())
        self.robot = self.simulation.spawn(model, "rover", Pose2D(*WAY[0], 0.0))
        self.lidar = Lidar(beams=360, range_max=10.0, noise=0.01)
        self.laser = Laser(self.lidar.angle_min, self.lidar.step, self.lidar.range_min, self.lidar.range_max)
        self.chance, self.slam = np.random.default_rng(seed), Slam()
        self.start = pose(self.robot.place)
        self.look()
        for goal in WAY[1:]:
            self.drive_to(*goal)
        self.slam.finish()

    def drive_to(self, x, y):
        here = self.robot.place
        while math.hypot(x - here.x, y - here.y) > 0.35:
            off = (math.atan2(y - here.y, x - here.x) - here.theta + math.pi) % (2 * math.pi) - math.pi
            self.robot.command(0.5 * max(0.0, math.cos(off)) ** 3, max(-1.2, min(1.2, 2 * off)), 0)
            self.simulation.advance(0.1)
            here = self.robot.place
            assert self.simulation.now_ns < 600e9, f"stuck on the way to ({x}, {y})"
            self.look()

    def look(self):
        ranges = self.lidar.measure(self.simulation.scan(self.lidar, self.robot), self.chance)
        self.slam.add_ranges(self.simulation.now_ns * 1e-9, ranges, self.laser, pose(self.robot.odometer.place))

    def comparison(self):
        grid, scene = self.slam.map(), self.simulation.scene(self.lidar.height)
        self.simulation.remove("rover")
        cuts = (scene.fixed, self.simulation.scene(self.lidar.height).moving())
        outline = np.concatenate([outline_points(cut.edges, cut.circles) for cut in cuts])
        drawn = GridMap(grid.trinary(), grid.resolution, (float(grid.origin[0]), float(grid.origin[1]), 0.0))
        return compare(drawn, self.start.inverse().transform(outline))


@pytest.mark.parametrize("seed", [0, 20271])
def test_the_map_is_the_warehouse(seed):
    tour = Tour(seed)
    truth = tour.start.to(pose(tour.robot.place))
    assert tour.start.to(pose(tour.robot.odometer.place)).distance(truth) > 1.0, "the odometry alone is no use"
    assert tour.slam.pose.distance(truth) < 0.05
    told = tour.comparison()
    assert told.iou > 0.9, str(told)
