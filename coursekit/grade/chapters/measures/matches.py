"""New scans, the poses that a student's matcher finds, and causes of wrong poses."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from coursekit.grade.plain import called, numbers

if TYPE_CHECKING:
    from random import Random

    from coursekit.grade.matching import Pose, Puzzle


def why_pose(off: float, turned: float, moved: float) -> str:
    """Return the likely cause of a pose with these errors [m, rad] and this distance from the guess [m]."""
    if moved < 1e-9:
        return "It still stands where the guess was."
    if off > 0.35:
        return "That is further off than the guess: are the points turned by the heading first, and then moved?"
    if off <= 0.03 and turned > 0.02:
        return "The place is right, the heading is not: is it in radians, and are finer headings tried at the end?"
    if off > 0.15:
        return "Do the tries reach 0.3 m and 0.15 rad around the guess?"
    return "Near, but not there: finer steps at the end?"


def puzzle_in(world: Path, chance: Random) -> Puzzle:
    """Return a new scan that fits in only one place: in a corridor it may also fit further along."""
    from coursekit.grade.matching import Puzzle

    while True:
        puzzle = Puzzle(world, chance.getrandbits(60))
        x, y, heading = puzzle.truth
        ways = [(far, k * math.pi / 8) for far in (0.06, 0.1, 0.15, 0.2, 0.3, 0.4) for k in range(16)]
        beside = [(x + far * math.cos(way), y + far * math.sin(way), heading) for far, way in ways]
        if min(puzzle.misfit(pose) for pose in beside) > 1.5 * puzzle.misfit(puzzle.truth):
            return puzzle


@dataclass(frozen=True)
class Match:
    """The pose found for a scan, and its error [m, rad]."""

    puzzle: Puzzle
    pose: Pose
    off: float
    turned: float
    told: str

    def moved(self) -> float:
        """Return the distance between pose and guess [m]."""
        return math.dist(self.pose[:2], self.puzzle.guess[:2])


def try_match(match: Any, puzzle: Puzzle, told: str) -> Match:
    """Return the matcher's pose for a scan; Wrong when it returns no pose."""
    got = called(match, puzzle.points.copy(), puzzle.gap, puzzle.guess, told=f"match, the scan {told}")
    x, y, heading = numbers(got, 3, "three finite numbers (x, y, heading) from match")
    turned = abs(math.remainder(heading - puzzle.truth[2], math.tau))
    return Match(puzzle, (x, y, heading), math.dist((x, y), puzzle.truth[:2]), turned, told)
