"""Runs flake8 with ROS's settings: 99 columns, single quotes are not enforced here."""

from __future__ import annotations

import importlib.util
import subprocess
import sys
import unittest
from collections.abc import Sequence

_SETTINGS = ("--max-line-length=99", "--extend-ignore=W503,E203", "--exclude=build,install,log,.git")


def main_with_errors(argv: Sequence[str] | None = None) -> tuple[int, list[str]]:
    """Return 0 or 1, and one line for each finding; raises SkipTest where flake8 is not installed."""
    if importlib.util.find_spec("flake8") is None:
        raise unittest.SkipTest("flake8 is not installed; `pip install flake8` to run this test")
    paths = list(sys.argv[1:] if argv is None else argv) or ["."]
    command = [sys.executable, "-m", "flake8", *_SETTINGS, *paths]
    result = subprocess.run(command, capture_output=True, encoding="utf-8", errors="replace", check=False)
    errors = [line for line in (result.stdout + result.stderr).splitlines() if line]
    return (1 if result.returncode else 0), errors


def main(argv: Sequence[str] | None = None) -> int:
    """Return 0 or 1 after printing the findings."""
    code, errors = main_with_errors(argv)
    print("\n".join(errors))
    return code
