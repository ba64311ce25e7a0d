"""Each source of C++ is compiled once, in however many folders the tests build it: where ccache is installed."""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
from pathlib import Path

LAUNCHERS = ("CMAKE_C_COMPILER_LAUNCHER", "CMAKE_CXX_COMPILER_LAUNCHER")
"""CMake's variables for a program that is given each command of the compiler."""
FOLDER = Path(__file__).resolve().parents[1] / ".pytest_cache" / "ccache"


def use() -> None:
    """Have every build that starts from here ask the cache first."""
    program = None if sys.platform == "win32" else shutil.which("ccache")
    if program:
        os.environ |= dict.fromkeys(LAUNCHERS, program)
        os.environ |= {"CCACHE_DIR": str(FOLDER), "CCACHE_BASEDIR": tempfile.gettempdir(), "CCACHE_NOHASHDIR": "1"}
        os.environ["CCACHE_ABSSTDERR"] = "1"  # what the compiler says names files as it does without a cache
