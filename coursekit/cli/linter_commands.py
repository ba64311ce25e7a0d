"""The commands `ament_copyright`, `ament_flake8` and `ament_pep257` for the terminal."""

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
    """List the sources without a copyright notice. Returns 1 if there are any."""
    return _copyright(argv)


def flake8(argv: Sequence[str] | None = None) -> int:
    """Report flake8's findings. Returns 1 if there are any, or if it is missing and no results file is requested."""
    return _or_told(_flake8, argv)


def pep257(argv: Sequence[str] | None = None) -> int:
    """Report pydocstyle's findings. Returns 1 if there are any, or if it is missing and no results file is requested."""
    return _or_told(_pep257, argv)


def _or_told(lint: Callable[[Sequence[str] | None], int], argv: Sequence[str] | None) -> int:
    try:
        return lint(argv)
    except unittest.SkipTest as missing:  # in a package, this skips the test
        print(missing, file=sys.stderr)
        parser = argparse.ArgumentParser(add_help=False)
        parser.add_argument("--xunit-file")
        asked, _ = parser.parse_known_args(argv)
        if not asked.xunit_file:
            return 1
        write_results(asked.xunit_file, [], [], 0.0, skipped=str(missing))
        return 0
