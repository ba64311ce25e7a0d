"""The commands `gazebo`, `gzserver` and `gzclient`: the simulator, started as launch files and tutorials start it."""

from __future__ import annotations

import sys
from collections.abc import Sequence

from . import parser, ros2

_SERVER = ("run", "gazebo_ros", "gzserver")
_CLIENT = ("run", "gazebo_ros", "gzclient")


def server() -> int:
    """`gazebo WORLD` or `gzserver WORLD` in a shell."""
    return ros2.main([*_SERVER, *sys.argv[1:]])


def run_server(argv: Sequence[str]) -> int:
    """The same inside of a session."""
    return parser.run([*_SERVER, *argv])


def client() -> int:
    """`gzclient` in a shell."""
    return ros2.main([*_CLIENT, *sys.argv[1:]])


def run_client(argv: Sequence[str]) -> int:
    """The same inside of a session."""
    return parser.run([*_CLIENT, *argv])
