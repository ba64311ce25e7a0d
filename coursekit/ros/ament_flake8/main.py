"""Runs flake8 with ROS's settings: 99 columns, single quotes are not enforced here."""

from __future__ import annotations

import argparse
import importlib.util
import re
import subprocess
import sys
import unittest
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

_LEFT_OUT = ("build", "install", "log", ".git")
_SETTINGS = ("--max-line-length=99", "--extend-ignore=W503,E203", f"--exclude={','.join(_LEFT_OUT)}")
_FINDING = re.compile(r"(.+?:\d+:\d+: )([A-Z]+\d+)( .*)")


def main_with_errors(argv: Sequence[str] | None = None) -> tuple[int, list[str]]:
    """Return 0 or 1, and one line for each finding; raises SkipTest where flake8 is not installed."""
    paths, options = _asked(argv)
    code, lines = _run([*options, *paths])
    return code, lines


def main(argv: Sequence[str] | None = None) -> int:
    """Return 0 or 1 after printing the findings, how many there are of each kind, and which files were read."""
    paths, options = _asked(argv)
    code, lines = _run(["--show-source", *options, *paths])
    for line in lines:
        print(f"\n{line}" if _FINDING.fullmatch(line) else line)
    found = Counter(one[2] + one[3] for line in lines if (one := _FINDING.fullmatch(line)))
    _summarize(found, sorted(_python_files(paths)))
    return code


def _asked(argv: Sequence[str] | None) -> tuple[list[str], list[str]]:
    """The paths to read, and what flake8 is told."""
    parser = argparse.ArgumentParser(prog="ament_flake8", description="Check code using flake8.")
    parser.add_argument("--config", metavar="path", help="The config file")
    parser.add_argument("--linelength", metavar="N", type=int, help="The maximum line length")
    parser.add_argument("--exclude", metavar="filename", nargs="*", default=[], help="The filenames to exclude.")
    parser.add_argument("paths", nargs="*", default=["."], help="The files or directories to check.")
    asked = parser.parse_args(argv)
    options = [f"--config={asked.config}"] if asked.config else []
    options += [f"--max-line-length={asked.linelength}"] if asked.linelength else []
    options += [f"--extend-exclude={','.join(asked.exclude)}"] if asked.exclude else []
    return asked.paths, options


def _run(words: Sequence[str]) -> tuple[int, list[str]]:
    if importlib.util.find_spec("flake8") is None:
        raise unittest.SkipTest("flake8 is not installed: `pip install flake8` brings it")
    command = [sys.executable, "-m", "flake8", *_SETTINGS, *words]
    result = subprocess.run(command, capture_output=True, encoding="utf-8", errors="replace", check=False)
    return int(result.returncode != 0), [line for line in (result.stdout + result.stderr).splitlines() if line]


def _python_files(paths: Sequence[str]) -> Iterator[str]:
    for path in map(Path, paths):
        inside = path.rglob("*.py") if path.is_dir() else [path]
        yield from (str(one) for one in inside if not set(one.parts) & set(_LEFT_OUT))


def _summarize(found: Counter[str], files: list[str]) -> None:
    print()
    if found:
        print("\n".join(f"{count:<5} {what}" for what, count in sorted(found.items())) + "\n")
    print(f"{len(files)} files checked\n{f'{found.total()} errors' if found else 'No problems found'}\n")
    kinds = Counter(letter for what, count in found.items() for letter in what[0] * count)
    print("".join(f"'{letter}'-type errors: {count}\n" for letter, count in sorted(kinds.items())))
    print("Checked files:\n" + "".join(f"\n* {one}" for one in files))
