"""Tests and chapters on Windows' Python under Wine.

python -m tests.windows [ci [SECONDS] | fast | all | only PIECE... | setup | run PROGRAM WORD...]

`ci` runs what there is time for, `fast` what knows of systems, and five chapters; `all`, which is the default, every
chapter and every test; `only` some of these by their names (`"chapter 8"`, `cli`, `"cli, slow"`). At its end it says what
passed, and the reasons of what was skipped.

COURSEKIT_WINE names the folder of the set-up (about 2 GB), JOBS how many tests run side by side. One such command at a time:
the end of one stops Wine's services, and with them the workers of another.
"""

from __future__ import annotations

import sys
from collections.abc import Callable

from . import leg, pieces, results, setup, wine

NO_WINE = "Windows: SKIPPED, there is no Wine (Debian: apt-get install wine64; it is for x86-64 only)."
TODO: dict[str, Callable[[list[str]], list[pieces.Piece | pieces.FromOutside]]] = {
    "fast": lambda _: [*pieces.FAST],
    "all": lambda _: pieces.everything(),
    "only": pieces.named,
    "setup": lambda _: [],
}


def main(words: list[str]) -> int:
    """Do what the command says; the exit code is that of the first part that fails."""
    what, *rest = words or ["all"]
    if not wine.is_there():
        print(NO_WINE, file=sys.stderr)
        return 0
    if what == "ci":
        return leg.main(*map(float, rest))
    if what not in (*TODO, "run"):
        print(f"There is no '{what}'.\n{__doc__}", file=sys.stderr)
        return 2
    todo = TODO[what](rest) if what != "run" else []
    setup.set_up()
    try:
        return wine.run(*rest) if what == "run" else run(todo)
    finally:
        wine.stop_services()


def run(todo: list[pieces.Piece | pieces.FromOutside]) -> int:
    """Run all pieces, whatever becomes of each, and say what became of them; the exit code of the first that fails."""
    names = [piece.name for piece in todo]
    results.forget(names)
    codes = [piece.run() for piece in todo]
    print(results.table(names), flush=True)
    return next((code for code in codes if code), 0)


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
