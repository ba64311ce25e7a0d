"""SLAM on the logs of the benchmark: five runs each with perturbed odometry and ranges; prints JSON.

Argument: the folder with the logs. One parameter set, the library's own.
"""

import json
import math
import statistics
import sys
import time
from pathlib import Path

import numpy as np

from coursekit.geometry.plane import Pose2D
from coursekit.slam.carmen import CarmenLog, read_log
from coursekit.slam.precompile import warm
from coursekit.slam.relations import errors, read_relations
from coursekit.slam.scan import Scan
from coursekit.slam.slam import Slam

RUNS = 5
LOGS = {"fr079": "fr079", "Intel": "intel_first5505"}
RANGE_NOISE, WAY_NOISE, TURN_NOISE = 0.005, 0.02, 0.02
"""Added to every range [m], and to each motion as a part of it."""


def perturbed(log: CarmenLog, seed: int) -> list[tuple[np.ndarray, Pose2D]]:
    """Ranges and odometry, each a little different with each seed; seed 0 is the log as it is."""
    rng = np.random.default_rng(seed)
    odometry, before, scans = log.readings[0].odometry, log.readings[0].odometry, []
    for reading in log.readings:
        motion, before = before.to(reading.odometry), reading.odometry
        way, noise = math.hypot(motion.x, motion.y), rng.normal(size=3) * bool(seed)
        odometry = odometry @ Pose2D(
            motion.x + noise[0] * WAY_NOISE * way,
            motion.y + noise[1] * WAY_NOISE * way,
            motion.theta + noise[2] * TURN_NOISE * abs(motion.theta),
        )
        shake = rng.normal(0, RANGE_NOISE, len(reading.ranges)) * bool(seed)
        scans.append((np.asarray(reading.ranges) + shake, odometry))
    return scans


def run(log: CarmenLog, relations: np.ndarray, seed: int) -> tuple[float, float, float]:
    """Translation error [m], rotation error [deg], seconds of one core: whatever else runs must not count."""
    inputs, lasers = perturbed(log, seed), log.lasers()
    begun, slam = time.process_time(), Slam()
    for (ranges, odometry), laser, reading in zip(inputs, lasers, log.readings, strict=True):
        slam.add(Scan.from_ranges(ranges, laser, slam.params, reading.stamp), odometry)
    slam.finish()
    seconds = time.process_time() - begun
    error = errors(slam.trajectory(), relations)
    return error.translation, error.rotation, seconds


def main() -> None:
    """Measure and print."""
    sys.path.insert(0, str(Path(__file__).parents[2]))
    from tests.benchmarks.icp_slam import icp_slam

    folder, result = Path(sys.argv[1]), {}
    warm()
    for name, stem in LOGS.items():
        log, relations = read_log(folder / f"{stem}.clf.xz"), read_relations(folder / f"{stem}.relations")
        runs = [run(log, relations, seed) for seed in range(1, RUNS + 1)]
        result[name] = {
            "translation": [round(outcome[0], 5) for outcome in runs],
            "median": statistics.median(outcome[0] for outcome in runs),
            "rotation": statistics.median(outcome[1] for outcome in runs),
            "speed": log.seconds / statistics.median(outcome[2] for outcome in runs),
            "peer": icp_slam(folder / f"{stem}.clf.xz", folder / f"{stem}.relations"),
        }
    print(json.dumps(result))


if __name__ == "__main__":
    main()
