"""Commands of programs with windows: `rviz2`, `rqt`, `rqt_graph` and others, which run here as nodes."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from pathlib import Path

from . import parser, ros2

_NODES = {"rqt": "rqt_gui"}
"""Commands whose package and executable have another name."""


def run_node() -> int:
    """Run `rviz2 ...` from a shell as `ros2 run rviz2 rviz2 ...`; likewise `rqt_graph` and others."""
    name = Path(sys.argv[0]).stem
    name = _NODES.get(name, name)
    return ros2.main(["run", name, name, *sys.argv[1:]])


def _inside(name: str) -> Callable[[Sequence[str]], int]:
    return lambda argv: parser.run(["run", name, name, *argv])


rviz2_inside, rqt_inside = _inside("rviz2"), _inside("rqt_gui")
"""The same commands inside a session."""
graph_inside, console_inside, plot_inside = _inside("rqt_graph"), _inside("rqt_console"), _inside("rqt_plot")
