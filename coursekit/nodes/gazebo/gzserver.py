"""`ros2 run gazebo_ros gzserver WORLD`: a simulator, run until Ctrl-C."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Iterable
from contextlib import closing
from typing import Any

import rclpy
from rclpy.utilities import remove_ros_args

from coursekit.nodes.running import to_the_end
from coursekit.processes.process import current_process
from coursekit.sim import WorldError
from coursekit.urdf import UrdfError

from .server import Gazebo


def _arguments(argv: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="gzserver", description="Simulate a world.")
    parser.add_argument("world", nargs="?", default="", help="a world file (yaml, SDF, a map) or one of the course's")
    parser.add_argument("-u", "--pause", action="store_true", help="start paused")
    parser.add_argument("--play", action="store_true", help="start at once (the default)")
    parser.add_argument("--seed", type=int, default=0, help="seed of noise and drift")
    parser.add_argument("--verbose", action="store_true", help="list all that is not simulated")
    parser.add_argument("--brief", action="store_true", help="list some of it (the default)")
    parser.add_argument("-s", dest="plugins", action="append", default=[], help="accepted: a system plugin")
    told, rest = parser.parse_known_args(argv)
    told.rest = rest
    return told


def simulate(make: Callable[[], Gazebo], unknown: Iterable[str]) -> int:
    """Run a simulator to its end; 255 for an invalid world. `unknown` command-line arguments are reported."""
    with to_the_end():
        try:
            node = make()
            node.tell([f"option {word}" for word in unknown])
        except (WorldError, UrdfError) as error:
            print(f"[Err] {error}", file=sys.stderr)
            return 255
        process = current_process()
        if process is not None:
            process.cleanups.append(node.close)
        with closing(node):
            node.spin()
    return 0


def main(args: list[str] | None = None) -> Any:
    """Run the simulator until Ctrl-C."""
    told = _arguments(remove_ros_args(args if args is not None else sys.argv)[1:])
    rclpy.init(args=args)
    return simulate(
        lambda: Gazebo(told.world, paused=told.pause, seed=told.seed, verbose=told.verbose),
        [f"{word} of Gazebo" for word in told.rest],
    )
