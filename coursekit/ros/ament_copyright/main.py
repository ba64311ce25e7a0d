"""Checks that source files begin with a copyright notice and a known license."""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections.abc import Iterator, Sequence
from pathlib import Path

from coursekit.files import read_text
from coursekit.xunit import write_results

from .notices import LICENSES, UNKNOWN, notice_of

_SUFFIXES = (".py", ".c", ".cc", ".cpp", ".cxx", ".h", ".hh", ".hpp", ".hxx", ".cmake")


def main(argv: Sequence[str] | None = None) -> int:
    """Return 0 when every source file below the folders has a notice and a license; else print the others and return 1."""
    began = time.monotonic()
    asked = _parser().parse_args(argv)
    if asked.list_licenses:
        print("\n".join(f"{name}: {title}" for name, title in sorted(LICENSES.items())))
        return 0
    excluded = {os.path.abspath(path) for path in asked.exclude}
    files = {source for word in asked.paths for source in _sources(Path(word)) if os.path.abspath(source) not in excluded}
    if not files:
        print("No repository roots and files found")
    cases = []
    for path in sorted(files):
        good, said = _judged(path)
        cases.append((str(path), "" if good else said))
        if not good or asked.verbose:
            print(f"{path}: {said}", file=sys.stdout if good else sys.stderr)
    bad = sum(1 for _, why in cases if why)
    counted = f"checked {len(files)} files"
    print(f"{bad} errors, {counted}" if bad else f"No problems found, {counted}", file=sys.stderr if bad else sys.stdout)
    if asked.xunit_file:
        write_results(asked.xunit_file, cases, [name for name, _ in cases], time.monotonic() - began)
    return int(bad > 0)


def _parser() -> argparse.ArgumentParser:
    about = "Check code files for copyright and license information."
    parser = argparse.ArgumentParser(prog="ament_copyright", description=about)
    parser.add_argument("paths", nargs="*", default=["."], help="The files or directories to check.")
    parser.add_argument("--exclude", metavar="filename", nargs="*", default=[], help="The filenames to exclude.")
    parser.add_argument("--list-licenses", action="store_true", help="List names of known licenses")
    parser.add_argument("--xunit-file", metavar="FILE", help="Generate a xunit compliant XML file")
    parser.add_argument("--verbose", action="store_true", help="Show all files instead of only the ones with errors")
    return parser


def _judged(path: Path) -> tuple[bool, str]:
    """Whether a file passes, and the text to report: its holders and license, or the reason."""
    try:
        text = read_text(path, errors="replace")
    except OSError as error:
        return False, f"cannot be read: {error.strerror}"
    if not text:
        return True, "file empty"
    notice = notice_of(text)
    if notice is None:
        return False, "could not find copyright notice"
    return notice.license != UNKNOWN, f"copyright={', '.join(notice.holders)}, license={notice.license}"


def _sources(path: Path) -> Iterator[Path]:
    """Yield the sources below a folder, or the file itself.

    Generated, hidden and ignored folders are skipped, and so is a package's setup.py.
    """
    if path.is_file():
        yield path
        return
    for place, folders, files in os.walk(path):
        if "AMENT_IGNORE" in (*folders, *files):
            folders.clear()
            continue
        folders[:] = [folder for folder in folders if folder[0] not in "._"]
        left_out = {"setup.py"} if "package.xml" in files else set()
        yield from (Path(place, file) for file in set(files) - left_out if Path(file).suffix in _SUFFIXES)
