"""Commands of programs with windows: `rviz2`, `rqt`, `rqt_graph` and others run here as the nodes that they are."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from pathlib import Path

from . import parser, ros2

_NODES = {"rqt": "rqt_gui"}
"""Commands whose package and program are called otherwise."""


def run_node() -> int:
    """`rviz2 ...` in a shell is `ros2 run rviz2 rviz2 ...`; so it is with `rqt_graph` and others."""
    name = Path(sys.argv[0]).stem
    name = _NODES.get(name, name)
    return ros2.main(["run", name, name, *sys.argv[1:]])


def _inside(name: str) -> Callable[[Sequence[str]], int]:
    return lambda argv: parser.run(["run", name, name, *argv])


rviz2_inside, rqt_inside = _inside("rviz2"), _inside("rqt_gui")
"""The same inside of a session."""
graph_inside, console_inside, plot_inside = _inside("rqt_graph"), _inside("rqt_console"), _inside("rqt_plot")
