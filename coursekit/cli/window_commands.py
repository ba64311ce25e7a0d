"""Commands of programs with windows: `rviz2` and `rqt_image_view` run here, those of rqt say what stands in for them."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from coursekit.core.elsewhere import remark
from coursekit.systems.streams import use_utf8

from . import parser, ros2


def run_node() -> int:
    """`rviz2 ...` in a shell is `ros2 run rviz2 rviz2 ...`; so is `rqt_image_view`."""
    name = Path(sys.argv[0]).stem
    return ros2.main(["run", name, name, *sys.argv[1:]])


def rviz2_inside(argv: Sequence[str]) -> int:
    """The same inside of a session."""
    return parser.run(["run", "rviz2", "rviz2", *argv])


def explain() -> int:
    """`rqt`, `rqt_graph`, ... in a shell: why there is no such window, and what to type instead."""
    use_utf8()
    print(remark(Path(sys.argv[0]).stem), file=sys.stderr)
    return 1
