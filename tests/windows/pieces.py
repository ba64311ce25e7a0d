"""What of the tests and chapters is run in Wine in one go: rooms of tests, and chapters."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterable
from dataclasses import dataclass

from . import results, wine

ROOMS = ("core", "processes", "rcl", "systems", "packages", "launch", "cli", "lab", "grade")
"""The rooms that know of systems."""
CHAPTERS = ("0", "1", "2", "5", "8")
"""The chapters that a student begins with, and the one with maps."""
CELL_SECONDS = "600"
"""For one cell: the first one that maps or plans waits for Numba's compiler, which takes minutes in Wine."""
EVERY_CHAPTER = (*map(str, range(11)), *"ABCD")
LINUX_SAYS = (
    "coursekit/systems/child_terminal.py", "coursekit/systems/children.py", "coursekit/systems/inherited.py",
    "coursekit/systems/command_lines.py", "coursekit/systems/layout.py", "coursekit/systems/links.py",
    "coursekit/systems/shell_spelling.py", "coursekit/packages/folder_name.py", "coursekit/grade/folders.py",
    "coursekit/share/launch_testing/examples/good_proc_launch_test.py",
)  # fmt: skip
"""Docstrings with an example of what differs by system, as Linux has it (tests/systems has Windows' answers), and a launch
test whose program has to be interrupted, where Humble's launch on Windows ends it."""
NOT_IN_WINE = ("browser", "windows")
"""They begin outside: with Chromium, or with Wine itself."""


@dataclass(frozen=True)
class Piece:
    """Tests or chapters under a name; `run` is what they are for."""

    name: str
    paths: tuple[str, ...]
    words: tuple[str, ...] = ()
    chapters: bool = False

    def run(self, seconds: float | None = None, again: bool = False) -> int:
        """pytest's exit code, 124 when it takes longer; `again` runs of tests only those that have failed.

        What became of each test is in the file of `results`; of those that ran again, it is in none.
        """
        jobs = os.environ.get("JOBS", "2")
        words = ["-n", jobs, "--dist", "loadfile", "-rs", "-o", f"cache_dir={wine.windows_path(wine.HOME / 'cache')}"]
        words += ["--lf"] if again and not self.chapters else [f"--junitxml={wine.windows_path(results.file_of(self.name))}"]
        extra = {"COURSEKIT_TIME": "virtual"} if self.chapters else {}
        code = wine.run(wine.PYTHON, "-m", "pytest", *words, *self.words, *self.paths, extra=extra, seconds=seconds)
        if seconds and code == 124:
            wine.stop_services()
        return code


@dataclass(frozen=True)
class FromOutside:
    """Tests that begin outside of Wine: with a Chromium, or a compiler."""

    name: str
    path: str

    def run(self) -> int:
        """pytest's exit code."""
        command = [sys.executable, "-m", "pytest", f"--junitxml={results.file_of(self.name)}", self.path]
        return subprocess.run(command, cwd=wine.ROOT, env=os.environ | {"COURSEKIT_WINE_LAB": "1"}, check=False).returncode


OUTSIDE = (
    FromOutside("JupyterLab", "tests/browser/test_windows.py"),
    FromOutside("C++", "tests/windows/test_cpp.py"),
    FromOutside("C++ there", "tests/windows/test_cpp_there.py"),
)
"""A student's way in the lab of Windows' Python; nodes in C++ that zig compiles for Windows, here and there."""


def chapter(name: str) -> Piece:
    """A chapter by its number or letter: its outputs are compared, on the virtual clock."""
    return chapters(name)


def chapters(*names: str) -> Piece:
    """Chapters side by side."""
    files = [_file_of(name) for name in names]
    words = ("-p", "tests.notebooks.own_course", "--nbval", "--nbval-cell-timeout", CELL_SECONDS, "--timeout", "900")
    return Piece(f"chapter{'s' * (len(names) > 1)} {' '.join(names)}", tuple(files), words, chapters=True)


def _file_of(chapter: str) -> str:
    [file] = (wine.ROOT / "notebooks").glob(f"{chapter.zfill(2) if chapter.isdigit() else chapter}_*.ipynb")
    return f"notebooks/{file.name}"


def fast(name: str, *without: str) -> Piece:
    """A room of tests without its slow ones and without some files."""
    ignored = tuple(f"--ignore=tests/{name}/{file}" for file in without)
    return Piece(name, (f"tests/{name}",), ("-m", "not slow", *ignored))


def slow(name: str) -> Piece:
    """A room's slow tests."""
    return Piece(f"{name}, slow", (f"tests/{name}",), ("-m", "slow"))


def every_room() -> list[str]:
    """The folders of tests that can run in Wine."""
    folders = sorted(path.name for path in (wine.ROOT / "tests").iterdir() if any(path.glob("test_*.py")))
    return [name for name in folders if name not in NOT_IN_WINE]


def everything() -> list[Piece | FromOutside]:
    """All chapters and tests, the quickest to tell something first; the docstrings' examples are tests, too."""
    rooms = every_room()
    loose = tuple(f"tests/{path.name}" for path in sorted((wine.ROOT / "tests").glob("test_*.py")))
    beside = [Piece("files", loose), Piece("docstrings", ("coursekit",), tuple(f"--ignore={path}" for path in LINUX_SAYS))]
    return [*map(chapter, EVERY_CHAPTER), *OUTSIDE, *map(fast, rooms), *beside, *map(slow, rooms)]


def named(names: Iterable[str]) -> list[Piece | FromOutside]:
    """Pieces by their names; SystemExit lists the names when there is none such."""
    known = {piece.name: piece for piece in everything()}
    if wrong := [name for name in names if name not in known]:
        raise SystemExit(f"There is no piece {', '.join(wrong)}; there are: {', '.join(known)}.")
    return [known[name] for name in names]


FAST = [*map(fast, ROOMS), *map(chapter, CHAPTERS)]
_BUILDS = ("test_build_state.py", "test_cmake_tests.py", "test_colcon.py", "test_links.py", "test_quiet.py")
"""They build for minutes, and Wine 8 refuses to start one of some twenty programs (WinError 1359) on a busy computer."""
_LONG = ("test_completion.py", "test_neighbours.py")
"""They start many interpreters, which takes seconds each in Wine."""
_FILES_OF_A_CLASS = ("collecting", "container", "exchange", "handing_back", "handing_in", "release", "review")
IN_CI = [
    fast("core"), fast("systems"), chapters("0", "1"), fast("launch"), fast("packages", *_BUILDS), chapters("2", "5", "8"),
    Piece("files of a class", tuple(f"tests/grade/test_{name}.py" for name in _FILES_OF_A_CLASS), ("-m", "not slow")),
    fast("lab"), fast("cli", *_LONG), fast("joined"), fast("bag"), fast("urdf"), fast("interfaces"), fast("processes"),
    fast("rcl"), fast("conformance"), fast("tf"), fast("ros"), fast("nodes"), fast("launch_testing"), fast("net"),
    fast("tutorials"),
]  # fmt: skip
"""What passed every time that it was run, in the order of what it tells of Windows for its time."""
