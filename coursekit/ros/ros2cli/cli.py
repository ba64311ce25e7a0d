"""The command `ros2` for calls from Python."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import Any

from coursekit.cli.parser import run


def main(
    *, script_name: str = "ros2", argv: Sequence[str] | None = None, description: str | None = None, extension: Any = None
) -> int:
    """Run `ros2 ARGV` (by default the interpreter's own arguments) in this program. Return the exit code."""
    return run(sys.argv[1:] if argv is None else list(argv))
