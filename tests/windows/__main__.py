"""Tests and chapters on Windows' Python under Wine.

python -m tests.windows [ci [SECONDS] | fast | all | setup | run PROGRAM WORD...]

`ci` runs what there is time for, `fast` what knows of systems, and five chapters; `all`, which is the default, every test
and every chapter. COURSEKIT_WINE names the folder of the set-up (about 2 GB), JOBS how many tests run side by side.
"""

from __future__ import annotations

import sys

from . import leg, pieces, setup, wine

NO_WINE = "Windows: SKIPPED, there is no Wine (Debian: apt-get install wine64; it is for x86-64 only)."


def main(words: list[str]) -> int:
    """Do what the command says; the exit code is that of the first part that fails."""
    what, *rest = words or ["all"]
    if not wine.is_there():
        print(NO_WINE, file=sys.stderr)
        return 0
    if what == "ci":
        return leg.main(*map(float, rest))
    todo = {"run": [], "setup": [], "fast": pieces.FAST, "all": pieces.ALL}.get(what)
    if todo is None:
        print(f"There is no '{what}'.\n{__doc__}", file=sys.stderr)
        return 2
    setup.set_up()
    try:
        if what == "run":
            return wine.run(*rest)
        return next((code for piece in todo if (code := piece.run())), 0)
    finally:
        wine.stop_services()


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
