"""A scan of 360 beams among 50 and 1000 edges, by ours and by pymunk ray by ray; prints JSON (microseconds)."""

import json
import math
import timeit

import numpy as np
import pymunk

from coursekit.geometry.plane import Pose2D
from coursekit.sim import Cut, Lidar

BEAMS, REACH = 360, 20.0


def scene(count: int) -> Cut:
    """Edges of one metre in a square of 20 m."""
    chance = np.random.default_rng(count)
    centre, turn = chance.uniform(-10, 10, (count, 2)), chance.uniform(0, 7, count)
    half = 0.5 * np.column_stack((np.cos(turn), np.sin(turn)))
    return Cut(np.hstack((centre - half, centre + half)), np.zeros((0, 3)))


def best(function: object, count: int) -> float:
    """The time of one call [µs]."""
    return min(timeit.repeat(function, number=count, repeat=5)) / count * 1e6  # type: ignore[arg-type]


def pymunk_time(cut: Cut) -> float:
    """A segment query for each beam."""
    space = pymunk.Space()
    for x1, y1, x2, y2 in cut.edges:
        space.add(pymunk.Segment(space.static_body, (x1, y1), (x2, y2), 0.0))
    ends = [(REACH * math.cos(2 * math.pi * k / BEAMS), REACH * math.sin(2 * math.pi * k / BEAMS)) for k in range(BEAMS)]
    everything = pymunk.ShapeFilter()
    return best(lambda: [space.segment_query_first((0, 0), end, 0.0, everything) for end in ends], 20)


def main() -> None:
    """Measure and print."""
    lidar = Lidar(beams=BEAMS, range_max=REACH)
    result = {}
    for count in (50, 1000):
        cut = scene(count)
        lidar.look(cut, Pose2D())
        result[count] = {"ours": best(lambda cut=cut: lidar.look(cut, Pose2D()), 500), "peer": pymunk_time(cut)}
    print(json.dumps(result))


if __name__ == "__main__":
    main()
