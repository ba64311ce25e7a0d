"""Runs pydocstyle with ROS's settings: existing docstrings are checked, missing ones are accepted."""

from __future__ import annotations

import argparse
import importlib.util
import os
import re
import subprocess
import sys
import time
import unittest
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from coursekit.xunit import write_results

_IGNORED = ("D100", "D101", "D102", "D103", "D104", "D105", "D106", "D107", "D203", "D212", "D404")
_CONVENTIONS = ("ament", "google", "numpy", "pep257")
_FINDING = re.compile(r"^(?P<place>(?P<file>.+?):(?P<line>\d+) .*):\n\s+(?P<what>(?P<code>D\d+): .*)$", re.M)
_UNREADABLE = re.compile(r"Error in file (.*): (Cannot parse file\.)")


class _Finding(NamedTuple):
    """A finding: its file, its position, its text, and its name in the results."""

    file: str
    place: str
    what: str
    name: str


def main(argv: Sequence[str] | None = None) -> int:
    """Return 0 or 1 after printing the findings; raises SkipTest where pydocstyle is not installed."""
    if importlib.util.find_spec("pydocstyle") is None:
        raise unittest.SkipTest("pydocstyle is not installed: `pip install pydocstyle` brings it")
    began = time.monotonic()
    asked = _parser().parse_args(argv)
    excluded = {os.path.abspath(name) for name in asked.exclude}
    files = sorted({source for path in asked.paths for source in _sources(path) if os.path.abspath(source) not in excluded})
    for file in files:
        print(f"checking {file}")
    findings = _findings(files, _chosen(asked)) if files else []
    for finding in findings:
        print(f"{finding.place}: {finding.what}", file=sys.stderr)
    print(f"{len(findings)} errors" if findings else "No problems found", file=sys.stderr if findings else sys.stdout)
    if asked.xunit_file:
        write_results(asked.xunit_file, _cases(files, findings), files, time.monotonic() - began)
    return int(bool(findings))


def _parser() -> argparse.ArgumentParser:
    about = "Check docstrings against the style conventions in PEP 257."
    parser = argparse.ArgumentParser(prog="ament_pep257", description=about)
    kinds = parser.add_mutually_exclusive_group()
    kinds.add_argument("--ignore", nargs="+", help="The codes to ignore, in place of ROS's")
    kinds.add_argument("--select", nargs="+", help="The codes to look for, no others")
    kinds.add_argument("--convention", choices=_CONVENTIONS, default="ament", help="A set of codes")
    parser.add_argument("--add-ignore", nargs="+", default=[], help="More codes to ignore")
    parser.add_argument("--add-select", nargs="+", default=[], help="More codes to look for")
    parser.add_argument("--exclude", metavar="filename", nargs="*", default=[], help="The filenames to exclude.")
    parser.add_argument("--xunit-file", metavar="FILE", help="Generate a xunit compliant XML file")
    parser.add_argument("paths", nargs="*", default=["."], help="The files or directories to check.")
    return parser


def _chosen(asked: argparse.Namespace) -> list[str]:
    """The arguments of pydocstyle that select the requested codes."""
    if asked.select:
        return [f"--select={','.join([*asked.select, *asked.add_select])}"]
    if asked.convention != "ament":
        more = {"--add-select": asked.add_select, "--add-ignore": asked.add_ignore}
        return [f"--convention={asked.convention}", *(f"{word}={','.join(codes)}" for word, codes in more.items() if codes)]
    ignored = [code for code in (*(asked.ignore or _IGNORED), *asked.add_ignore) if code not in asked.add_select]
    return [f"--ignore={','.join(ignored)}"]


def _sources(path: str) -> Iterator[str]:
    """Yield the Python files below a folder, except those in hidden folders, or the file itself."""
    if os.path.isfile(path):
        yield path
    for place, folders, files in os.walk(path):
        folders[:] = [folder for folder in folders if folder[0] not in "._"]
        yield from (os.path.join(place, file) for file in files if file.endswith(".py"))


def _cases(files: list[str], findings: list[_Finding]) -> list[tuple[str, str]]:
    """Each finding as a case, and each file without findings."""
    by_file: dict[str, list[tuple[str, str]]] = {file: [] for file in files}
    for finding in findings:
        by_file.setdefault(finding.file, []).append((finding.name, finding.what))
    return [case for file, own in by_file.items() for case in own or [(file, "")]]


def _findings(files: list[str], chosen: list[str]) -> list[_Finding]:
    command = [sys.executable, "-m", "pydocstyle", *chosen, *files]
    result = subprocess.run(command, capture_output=True, encoding="utf-8", errors="replace", check=False)
    print(result.stderr.replace("WARNING: ", ""), end="", file=sys.stderr)
    findings = [
        _Finding(match["file"], match["place"], match["what"], f"{match['code']} ({match['file']}:{match['line']})")
        for match in _FINDING.finditer(result.stdout)
    ]
    return findings + [_Finding(file, file, why, file) for file, why in _UNREADABLE.findall(result.stderr)]
