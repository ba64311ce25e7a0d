"""The Windows leg of CI: as many pieces of `make windows` as its time allows, and loud words about what it leaves out."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass

from . import pieces, wine

SECONDS = 900.0
"""How long the leg may take, with its set-up."""
FOR_TESTS = 300.0
"""So much of it is for tests: the set-up has the rest."""
NO_START = 60.0
"""How long before its end no piece is begun any more: what is cut is told as left out."""
TOO_LONG = 124
"""The exit code of `timeout` when it has ended a program."""


@dataclass(frozen=True)
class Leg:
    """The time that is left, and what is done with it; `clock` gives seconds."""

    seconds: float
    clock: Callable[[], float] = time.monotonic
    say: Callable[[str], None] = lambda text: print(f"Windows: {text}", flush=True)

    def run(self, set_up: Callable[[float], int], todo: list[pieces.Piece]) -> int:
        """1 when a piece fails, else 0: what there was no time for, or no set-up, is said and fails nothing.

        A piece that fails is tried once more where there is time, for Wine now and then refuses to start a program.
        """
        end = self.clock() + self.seconds
        if set_up(max(1.0, self.seconds - FOR_TESTS)):
            self.say("SKIPPED, for Wine's Python could not be set up in time; `make windows` does it without a limit.")
            return 0
        codes = {piece.name: self._one(piece, end) for piece in todo}
        self._sum_up(codes, self.seconds - (end - self.clock()))
        return int(any(code for code in codes.values()))

    def _one(self, piece: pieces.Piece, end: float) -> int | None:
        """The piece's exit code; None when it was not run to its end."""
        code: int | None = None
        for again in (False, True):
            left = end - self.clock()
            if left <= NO_START:
                break
            code = piece.run(left - 10, again)
            self.say(f"{piece.name}: {'passed' if code == 0 else f'exit code {code}'}, {end - self.clock():.0f} s are left")
            if code == 0:
                break
        return None if code == TOO_LONG else code

    def _sum_up(self, codes: dict[str, int | None], seconds: float) -> None:
        left_out = [name for name, code in codes.items() if code is None]
        failed = [name for name, code in codes.items() if code]
        passed = [name for name, code in codes.items() if code == 0]
        self.say(f"{len(passed)} of {len(codes)} pieces passed in {seconds:.0f} s: {', '.join(passed)}.")
        if left_out:
            self.say(f"LEFT OUT, for there was no time: {', '.join(left_out)}. `make windows` runs them.")
        if failed:
            self.say(f"FAILED: {', '.join(failed)}.")


def set_up(seconds: float) -> int:
    """Exit code of the set-up, in a program of its own, so that it can be ended."""
    command = ["timeout", "-k", "10", str(seconds), sys.executable, "-m", "tests.windows", "setup"]
    return subprocess.run(command, cwd=wine.ROOT, check=False).returncode


def main(seconds: float = SECONDS) -> int:
    """Run the leg in at most so many seconds."""
    leg = Leg(min(seconds, SECONDS))
    if leg.seconds <= FOR_TESTS:
        leg.say(f"SKIPPED, for {seconds:.0f} s are left to CI; `make windows` runs all.")
        return 0
    try:
        return leg.run(set_up, pieces.IN_CI)
    finally:
        wine.stop_services()
