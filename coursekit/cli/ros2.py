#!/usr/bin/env python3
# PYTHON_ARGCOMPLETE_OK
"""The command `ros2`.

It uses the running session of this user and ROS domain (the notebook's, or one that it starts). With COURSEKIT_TIME
or COURSEKIT_STOP_AFTER set it runs in its own session. If a real ROS 2 is sourced, that `ros2` runs instead.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from pathlib import Path

from coursekit.systems.streams import use_utf8


def real_ros2() -> Path | None:
    """Return the `ros2` of a real ROS 2 that is sourced in this shell, or None."""
    for prefix in os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep):
        candidate = Path(prefix) / "bin" / "ros2"
        if prefix and (Path(prefix) / "share" / "ros2cli").is_dir() and candidate.is_file():
            return candidate
    return None


def stands_alone() -> bool:
    """Whether the command should have its own session."""
    return bool(os.environ.get("COURSEKIT_TIME") or os.environ.get("COURSEKIT_STOP_AFTER"))


def run_alone(argv: Sequence[str]) -> int:
    """Run the command in a session of this process."""
    from coursekit.processes.session import current

    from .own_session import run_in

    return run_in(current(), argv)


def main(argv: Sequence[str] | None = None) -> int:
    """Run the shell command."""
    use_utf8()  # now, while the streams are still the system's
    argv = sys.argv[1:] if argv is None else argv
    real = real_ros2()
    if real is not None:
        os.execv(real, [str(real), *argv])
    if "_ARGCOMPLETE" in os.environ:
        import argcomplete

        from .parser import make_parser

        argcomplete.autocomplete(make_parser())
    if not argv or argv[0] in ("-h", "--help"):
        from .parser import run

        return run(argv)
    if stands_alone():
        return run_alone(argv)
    from .session_client import attach

    return attach(argv)


if __name__ == "__main__":
    sys.exit(main())
