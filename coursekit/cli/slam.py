"""`coursekit slam` and `coursekit slam-error`: convert a log to a trajectory and a map; score a trajectory."""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from coursekit.slam.carmen import CarmenLog
    from coursekit.slam.grid import OccupancyGrid
    from coursekit.slam.slam import Slam


def add_commands(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the two commands."""
    slam = commands.add_parser("slam", help="run SLAM on a CARMEN log (.clf, .log, also .gz, .bz2 and .xz)")
    slam.add_argument("log", metavar="LOG")
    slam.add_argument(
        "--trajectory", metavar="OUT", required=True, help="write 'stamp x y theta', a line for each scan"
    )
    slam.add_argument(
        "--map", metavar="OUT.yaml", help="write the map as nav2 reads it: a .yaml and a .pgm beside it"
    )
    slam.add_argument("--no-odometry", action="store_true", help="use the laser alone")
    slam.set_defaults(main=run_slam)
    error = commands.add_parser("slam-error", help="compare a trajectory with known relations")
    error.add_argument("trajectory", metavar="TRAJECTORY", help="lines 'stamp x y theta'")
    error.add_argument("relations", metavar="RELATIONS", help="lines 't1 t2 x y z roll pitch yaw'")
    error.set_defaults(main=run_error)


def run_error(args: argparse.Namespace) -> int:
    """Print the mean and the standard deviation of the errors."""
    from coursekit.slam.relations import errors, read_relations, read_trajectory

    try:
        summary = errors(read_trajectory(args.trajectory), read_relations(args.relations))
    except (OSError, ValueError) as fault:
        print(f"coursekit slam-error: {fault}", file=sys.stderr)
        return 1
    print(f"translation error: {summary.translation:.4f} ± {summary.translation_std:.4f} m")
    print(f"rotation error:    {summary.rotation:.3f} ± {summary.rotation_std:.3f} deg")
    left = f"; {summary.outside} outside of the trajectory were left out" if summary.outside else ""
    print(f"relations:         {summary.used}{left}")
    return 0


def run_slam(args: argparse.Namespace) -> int:
    """Run SLAM on a log, write the requested files, and print a summary."""
    from coursekit.slam.carmen import read_log

    try:
        log = read_log(args.log)
        for complaint in log.complaints:
            print(f"{args.log}, {complaint} (left out)", file=sys.stderr)
        if log.bad > len(log.complaints):
            print(f"{args.log}: {log.bad - len(log.complaints)} further bad lines left out", file=sys.stderr)
        begun = time.perf_counter()
        slam = _process(log, log.has_odometry and not args.no_odometry)
        _report(log, slam, time.perf_counter() - begun)
        _write(args, slam)
    except (OSError, ValueError) as fault:
        print(f"coursekit slam: {fault}", file=sys.stderr)
        return 1
    return 0


def _process(log: CarmenLog, odometry: bool) -> Slam:
    """Process a log, with progress on a terminal."""
    from coursekit.slam.scan import Scan
    from coursekit.slam.slam import Slam

    slam, count, shown = Slam(), len(log.readings), sys.stderr.isatty()
    for number, (reading, laser) in enumerate(zip(log.readings, log.lasers(), strict=True), start=1):
        scan = Scan.from_ranges(reading.ranges, laser, slam.params, reading.stamp)
        slam.add(scan, reading.odometry if odometry else None)
        if shown and (number % 100 == 0 or number == count):
            print(f"\r{number} of {count} scans, {len(slam.keyframes)} keyframes", end="", file=sys.stderr)
    if shown:
        print("\r\033[Krefining", end="", file=sys.stderr, flush=True)
    slam.finish()
    if shown:
        print("\r\033[K", end="", file=sys.stderr)
    return slam


def _report(log: CarmenLog, slam: Slam, seconds: float) -> None:
    """Print a short summary."""
    count = len(log.readings)
    odometry = "" if log.has_odometry else ", no odometry"
    print(f"scans:     {count} ({slam.lost} without a match{odometry})")
    print(f"keyframes: {len(slam.keyframes)}")
    print(f"loops:     {len(slam.loops)} accepted, {slam.rejected} rejected")
    ratio = f", {log.seconds / seconds:.0f} × real time" if log.seconds > 0 else ""
    print(f"speed:     {seconds:.1f} s, {1000 * seconds / count:.2f} ms a scan{ratio}")


def write_map(path: str | Path, drawn: OccupancyGrid) -> tuple[Path, Path]:
    """Write SLAM's map in nav2's format, PATH.yaml and PATH.pgm. Returns both paths. ValueError when it is empty."""
    from coursekit.nav.map_file import GridMap, save_map

    x, y = (float(number) for number in drawn.origin)
    return save_map(Path(path).with_suffix(".yaml"), GridMap(drawn.trinary(), drawn.resolution, (x, y, 0.0)))


def _write(args: argparse.Namespace, slam: Slam) -> None:
    """Write the trajectory, and the map if requested."""
    from coursekit.slam.relations import write_trajectory

    write_trajectory(args.trajectory, slam.trajectory())
    print(f"trajectory: {args.trajectory}")
    if args.map:
        print("map:        {} and {}".format(*write_map(args.map, slam.map())))
