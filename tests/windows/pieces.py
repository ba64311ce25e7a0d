"""What of the tests and chapters is run in Wine in one go: rooms of tests, and chapters."""

from __future__ import annotations

import os
from dataclasses import dataclass

from . import wine

ROOMS = ("core", "processes", "rcl", "systems", "packages", "launch", "cli", "lab", "grade")
"""The rooms that know of systems."""
CHAPTERS = ("00", "01", "02", "05", "08")
"""The chapters that a student begins with, and the one with maps."""


@dataclass(frozen=True)
class Piece:
    """Tests or chapters under a name; `run` is what they are for."""

    name: str
    paths: tuple[str, ...]
    words: tuple[str, ...] = ()
    chapters: bool = False

    def run(self, seconds: float | None = None, again: bool = False) -> int:
        """pytest's exit code, 124 when it takes longer; `again` runs of tests only those that have failed."""
        jobs = os.environ.get("JOBS", "2")
        words = ["-n", jobs, "--dist", "loadfile", "-rs", "-o", f"cache_dir={wine.windows_path(wine.HOME / 'cache')}"]
        words += ["--lf"] if again and not self.chapters else []
        extra = {"COURSEKIT_TIME": "virtual"} if self.chapters else {}
        code = wine.run(wine.PYTHON, "-m", "pytest", *words, *self.words, *self.paths, extra=extra, seconds=seconds)
        if seconds and code == 124:
            wine.stop_services()
        return code


def tests(name: str, *paths: str, words: tuple[str, ...] = ()) -> Piece:
    """A piece of tests, which are in folders or files; all of them where none is given."""
    return Piece(name, paths, words)


def chapters(name: str, *starts: str) -> Piece:
    """The chapters whose names begin so: their outputs are compared, on the virtual clock."""
    files = sorted((wine.ROOT / "notebooks").glob("*.ipynb"))
    names = tuple(f"notebooks/{one.name}" for one in files if one.name.startswith(starts))
    nbval = ("-p", "tests.notebooks.own_course", "--nbval", "--nbval-cell-timeout", "120")
    return Piece(name, names, nbval, chapters=True)


def _room(name: str, *without: str) -> Piece:
    ignored = tuple(f"--ignore=tests/{name}/{file}" for file in without)
    return tests(name, f"tests/{name}", words=("-m", "not slow", *ignored))


FAST = [*map(_room, ROOMS), *(chapters(f"chapter {one[1]}", one) for one in CHAPTERS)]
ALL = [tests("tests"), chapters("chapters", "")]
_BUILDS = ("test_build_state.py", "test_colcon.py", "test_links.py", "test_quiet.py")
"""They build for minutes, and Wine 8 refuses to start one of some twenty programs (WinError 1359) on a busy computer."""
IN_CI = [
    _room("systems"),
    chapters("chapter 0", "00"),
    _room("launch"),
    chapters("chapter 1", "01"),
    _room("packages", *_BUILDS),
]
"""What passed every time that it was run, in the order of what it tells of Windows for its time."""
