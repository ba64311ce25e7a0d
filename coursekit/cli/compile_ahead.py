"""`python -m coursekit.cli.compile_ahead`: compile the code of SLAM and the simulator before their first start.

numba caches compiled code on disk: the first run takes half a minute of one core, later ones a second. `coursekit
lab` starts this module with the lowest priority while the student reads chapter 0.
"""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
from collections.abc import Mapping

from coursekit.systems.children import apart


def start_in_background(env: Mapping[str, str]) -> None:
    """Start it in a child with lowest priority, which outlives this process; does nothing if that is impossible."""
    nothing = subprocess.DEVNULL
    command = [sys.executable, "-m", __name__]
    with contextlib.suppress(OSError):
        subprocess.Popen(command, env=dict(env), stdin=nothing, stdout=nothing, stderr=nothing, **apart())


def main() -> int:
    """Run all compiled code once."""
    if hasattr(os, "nice"):
        os.nice(19)
    from coursekit.nodes.gazebo.precompile import warm_up
    from coursekit.slam.precompile import warm

    warm()
    warm_up()
    return 0


if __name__ == "__main__":
    sys.exit(main())
