"""`python -m coursekit.cli.compile_ahead`: what SLAM and the simulator compile at their first start, compiled before.

numba keeps on disk what it has compiled: the first run takes half a minute of one core, later ones a second.
`coursekit lab` starts it with the lowest priority while the student reads chapter 0.
"""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
from collections.abc import Mapping

from coursekit.systems.children import apart


def start_in_background(env: Mapping[str, str]) -> None:
    """Begin it in a child that outlives this process and takes only time that nobody needs; harmless where it cannot."""
    nothing = subprocess.DEVNULL
    command = [sys.executable, "-m", __name__]
    with contextlib.suppress(OSError):
        subprocess.Popen(command, env=dict(env), stdin=nothing, stdout=nothing, stderr=nothing, **apart())


def main() -> int:
    """Use everything that is compiled once."""
    if hasattr(os, "nice"):
        os.nice(19)
    from coursekit.nodes.gazebo.warm_up import warm_up
    from coursekit.slam.warm import warm

    warm()
    warm_up()
    return 0


if __name__ == "__main__":
    sys.exit(main())
