"""Runs flake8 with ROS's settings: 99 columns, single quotes are not enforced here."""

from __future__ import annotations

import argparse
import importlib.util
import os
import re
import subprocess
import sys
import time
import unittest
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

from coursekit.xunit import write_results

_SETTINGS = str(Path(__file__).with_name("ament_flake8.ini"))
_LEFT_OUT = ("build", "install", "log")
"""colcon's output folders. Humble's ament_flake8 does not exclude them, but they contain no code of the user."""
_FINDING = re.compile(r"(.+?:\d+:\d+: )([A-Z]+\d+)( .*)")


def main_with_errors(argv: Sequence[str] | None = None) -> tuple[int, list[str]]:
    """Return 0 or 1, and one line for each finding; raises SkipTest where flake8 is not installed."""
    return _run(_words(_parser().parse_args(argv)))


def main(argv: Sequence[str] | None = None) -> int:
    """Return 0 or 1 after printing the findings, the number of each kind, and the files that were read."""
    began = time.monotonic()
    asked = _parser().parse_args(argv)
    code, lines = _run(["--show-source", *_words(asked)])
    for line in lines:
        print(f"\n{line}" if _FINDING.fullmatch(line) else line)
    findings = [(match[1], match[2], match[3]) for line in lines if (match := _FINDING.fullmatch(line))]
    findings.sort(key=lambda finding: finding[0].partition(":")[0])
    excluded = {os.path.abspath(path) for path in asked.exclude}
    files = {file for path in asked.paths for file in _python_files(path) if os.path.basename(file) not in asked.exclude}
    checked = sorted(file for file in files if os.path.abspath(file) not in excluded)
    _summarize(findings, checked)
    if asked.xunit_file:
        write_results(asked.xunit_file, _cases(lines) or [("flake8", "")], checked, time.monotonic() - began)
    return code


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="ament_flake8", description="Check code using flake8.")
    parser.add_argument("--config", metavar="path", default=_SETTINGS, help="The config file")
    parser.add_argument("--linelength", metavar="N", type=int, help="The maximum line length")
    parser.add_argument("--exclude", metavar="filename", nargs="*", default=[], help="The filenames to exclude.")
    parser.add_argument("--xunit-file", metavar="FILE", help="Generate a xunit compliant XML file")
    parser.add_argument("paths", nargs="*", default=["."], help="The files or directories to check.")
    return parser


def _words(asked: argparse.Namespace) -> list[str]:
    """The arguments of flake8."""
    ignored = [str(marker.parent) for path in asked.paths for marker in Path(path).rglob("AMENT_IGNORE")]
    words = [f"--config={asked.config}", f"--extend-exclude={','.join([*_LEFT_OUT, *asked.exclude, *ignored])}"]
    return [*words, *([f"--max-line-length={asked.linelength}"] if asked.linelength else []), *asked.paths]


def _run(words: Sequence[str]) -> tuple[int, list[str]]:
    if importlib.util.find_spec("flake8") is None:
        raise unittest.SkipTest("flake8 is not installed: `pip install flake8` brings it")
    command = [sys.executable, "-m", "flake8", *words]
    result = subprocess.run(command, capture_output=True, encoding="utf-8", errors="replace", check=False)
    return int(result.returncode != 0), [line for line in (result.stdout + result.stderr).splitlines() if line]


def _cases(lines: Sequence[str]) -> list[tuple[str, str]]:
    """Each finding as a case: its code and position, and its text with the source line that flake8 shows below it."""
    pairs = [(match, lines[at + 1 : at + 2]) for at, line in enumerate(lines) if (match := _FINDING.fullmatch(line))]
    return [(f"{match[2]} ({match[1][:-2]})", f"{match[3].strip()}:\n{''.join(source)}\n") for match, source in pairs]


def _python_files(path: str) -> Iterator[str]:
    """Yield the Python files below a folder, except those in excluded folders, or the file itself."""
    if os.path.isfile(path):
        yield path
    for place, folders, files in os.walk(path):
        folders[:] = [folder for folder in folders if folder not in _LEFT_OUT and folder[0] != "."]
        if "AMENT_IGNORE" in files:
            folders.clear()
        else:
            yield from (os.path.join(place, file) for file in files if file.endswith(".py"))


def _summarize(findings: Sequence[tuple[str, str, str]], files: list[str]) -> None:
    """Print the number of findings of each code, with the text of the first, and the files that were read."""
    print()
    counts, texts = Counter(code for _, code, _ in findings), {code: text for _, code, text in reversed(findings)}
    if findings:
        print("\n".join(f"{counts[code]:<5} {code}{texts[code]}" for code in sorted(counts)) + "\n")
    print(f"{len(files)} files checked\n{f'{len(findings)} errors' if findings else 'No problems found'}\n")
    for letter, count in sorted(Counter(code[0] for _, code, _ in findings).items()):
        print(f"'{letter}'-type errors: {count}")
    print("\n" * bool(findings), end="")
    print("Checked files:\n" + "".join(f"\n* {file}" for file in files))
