"""The commands `ament_copyright`, `ament_flake8` and `ament_pep257`, as a terminal calls them."""

from __future__ import annotations

import argparse
import sys
import unittest
from collections.abc import Callable, Sequence

from ament_copyright.main import main as _copyright
from ament_flake8.main import main as _flake8
from ament_pep257.main import main as _pep257

from coursekit.xunit import write_results


def copyright_notices(argv: Sequence[str] | None = None) -> int:
    """Name the sources without a copyright notice; 1 when there are any."""
    return _copyright(argv)


def flake8(argv: Sequence[str] | None = None) -> int:
    """Tell what flake8 finds; 1 when it finds anything, or is not installed and no file of results is asked for."""
    return _or_told(_flake8, argv)


def pep257(argv: Sequence[str] | None = None) -> int:
    """Tell what pydocstyle finds; 1 when it finds anything, or is not installed and no file of results is asked for."""
    return _or_told(_pep257, argv)


def _or_told(lint: Callable[[Sequence[str] | None], int], argv: Sequence[str] | None) -> int:
    try:
        return lint(argv)
    except unittest.SkipTest as missing:  # which skips the test of a package
        print(missing, file=sys.stderr)
        parser = argparse.ArgumentParser(add_help=False)
        parser.add_argument("--xunit-file")
        asked, _ = parser.parse_known_args(argv)
        if not asked.xunit_file:
            return 1
        write_results(asked.xunit_file, [], [], 0.0, skipped=str(missing))
        return 0
