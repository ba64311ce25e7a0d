"""The commands `gazebo`, `gzserver` and `gzclient`: the simulator, started as in launch files and tutorials."""

from __future__ import annotations

import sys
from collections.abc import Sequence

from . import parser, ros2

_SERVER = ("run", "gazebo_ros", "gzserver")
_CLIENT = ("run", "gazebo_ros", "gzclient")


def server() -> int:
    """Run `gazebo WORLD` or `gzserver WORLD` from a shell."""
    return ros2.main([*_SERVER, *sys.argv[1:]])


def run_server(argv: Sequence[str]) -> int:
    """Run the server inside a session."""
    return parser.run([*_SERVER, *argv])


def client() -> int:
    """Run `gzclient` from a shell."""
    return ros2.main([*_CLIENT, *sys.argv[1:]])


def run_client(argv: Sequence[str]) -> int:
    """Run the client inside a session."""
    return parser.run([*_CLIENT, *argv])
