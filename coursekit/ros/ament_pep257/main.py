"""Runs pydocstyle with ROS's settings: docstrings are checked where they exist, none is demanded."""

from __future__ import annotations

import importlib.util
import re
import subprocess
import sys
import unittest
from collections.abc import Sequence

_IGNORED = "D100,D101,D102,D103,D104,D105,D106,D107,D203,D212,D404"


def main(argv: Sequence[str] | None = None) -> int:
    """Return 0 or 1 after printing the findings; raises SkipTest where pydocstyle is not installed."""
    if importlib.util.find_spec("pydocstyle") is None:
        raise unittest.SkipTest("pydocstyle is not installed: `pip install pydocstyle` brings it")
    paths = list(sys.argv[1:] if argv is None else argv) or ["."]
    command = [sys.executable, "-m", "pydocstyle", f"--ignore={_IGNORED}", *paths]
    result = subprocess.run(command, capture_output=True, encoding="utf-8", errors="replace", check=False)
    said = result.stdout + result.stderr
    errors = len(re.findall(r"^\s+D\d+: ", said, re.M))
    print(said + (f"{errors} errors" if errors else "No errors"))
    return 1 if result.returncode else 0
