"""python -m tests.windows [fast | all | setup | run PROGRAM WORD...]: tests and chapters on Windows' Python under Wine.

`fast` runs what knows of systems, and five chapters; `all`, which is the default, every test and every chapter.
COURSEKIT_WINE names the folder of the set-up (about 2 GB), JOBS how many tests run side by side.
"""

from __future__ import annotations

import os
import sys

from . import setup, wine

ROOMS = [f"tests/{room}" for room in ("core", "systems", "packages", "launch", "cli", "lab", "grade")]
CHAPTERS = ["00", "01", "02", "05", "08"]
NO_WINE = "Windows: SKIPPED, there is no Wine (Debian: apt-get install wine64; it is for x86-64 only)."


def tests(*paths: str, extra: tuple[str, ...] = ()) -> int:
    """pytest's exit code for these folders, all of them where none is given."""
    jobs = os.environ.get("JOBS", "2")
    return wine.run(wine.PYTHON, "-m", "pytest", "-n", jobs, "--dist", "loadfile", "-rs", *extra, *paths)


def chapters(*starts: str) -> int:
    """The exit code of the chapters whose names begin so: their outputs are compared, on the virtual clock."""
    files = sorted((wine.ROOT / "notebooks").glob("*.ipynb"))
    names = [f"notebooks/{one.name}" for one in files if one.name.startswith(starts)]
    nbval = ["-p", "tests.notebooks.own_course", "--nbval", "--nbval-cell-timeout", "120"]
    jobs = ["-n", os.environ.get("JOBS", "2"), "--dist", "loadfile"]
    return wine.run(wine.PYTHON, "-m", "pytest", *jobs, *nbval, *names, extra={"COURSEKIT_TIME": "virtual"})


def main(words: list[str]) -> int:
    """Do what the command says; the exit code is that of the first part that fails."""
    what, *rest = words or ["all"]
    if not wine.is_there():
        print(NO_WINE, file=sys.stderr)
        return 0
    setup.set_up()
    try:
        if what == "run":
            return wine.run(*rest)
        if what == "fast":
            return tests(*ROOMS, extra=("-m", "not slow")) or chapters(*CHAPTERS)
        return 0 if what == "setup" else tests() or chapters("")
    finally:
        wine.stop_services()


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
