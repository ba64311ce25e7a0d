"""The commands `gazebo`, `gzserver` and `gzclient`: the simulator, started as launch files and tutorials start it."""

from __future__ import annotations

import sys
from collections.abc import Sequence

from coursekit.processes.session import current
from coursekit.systems.streams import use_utf8

from . import parser, ros2

_SERVER = ("run", "gazebo_ros", "gzserver")
_NO_WINDOW = "gzclient: the world has no window of its own. Look at it in a notebook, with viewer()."


def server() -> int:
    """`gazebo WORLD` or `gzserver WORLD` in a shell."""
    return ros2.main([*_SERVER, *sys.argv[1:]])


def run_server(argv: Sequence[str]) -> int:
    """The same inside of a session."""
    return parser.run([*_SERVER, *argv])


def client() -> int:
    """`gzclient` in a shell: it says where to look."""
    use_utf8()
    print(_NO_WINDOW)
    return 0


def run_client(_argv: Sequence[str]) -> int:
    """The same inside of a session: it stays until Ctrl-C, since launch files end everything when it ends."""
    print(_NO_WINDOW)
    current().clock.new_event().wait()
    return 0
