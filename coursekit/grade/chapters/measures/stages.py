"""The steps and stages of a robot of chapter 7: distances, speeds and goals."""

from __future__ import annotations

import math

from coursekit.grade.chapters.measures.reports import Spot
from coursekit.grade.plain import near
from coursekit.grade.verdict import NO_HINT, Wrong

STEP, TURN = 0.01, math.radians(1)
"""The maximum translation [m] and rotation [rad] of a robot per step."""


def judge_step(old: int, new: int, before: Spot, after: Spot) -> None:
    """Raise Wrong unless a step is within its limits, and of the kind required by its stage."""
    at = [after[:2]]
    moved, turned = math.dist(before[:2], after[:2]), abs(math.remainder(after[2] - before[2], math.tau))
    if not 0 <= old <= 5 or new not in (old, old + 1):
        raise Wrong(f"stage {old} or {old + 1} after a step in stage {old}", f"stage {new}", hint=NO_HINT, at=at)
    if moved > STEP + 1e-6 or turned > TURN + 1e-6:
        cause = "theta is in radians: 1° is math.radians(1)." if near(turned, 1.0, 1e-6) else ""
        seen = f"{moved:.4f} m and {math.degrees(turned):.2f}°"
        wanted = f"in stage {old} at most 0.01 m and 1° a step"
        raise Wrong(wanted, seen, cause, hint=NO_HINT if cause else 2, at=at)
    if old in (1, 4) and turned > 1e-6:
        wanted = f"in stage {old} the robot moves straight on"
        raise Wrong(wanted, f"it turns by {math.degrees(turned):.2f}°", share=0.3, hint=1, at=at)
    if old not in (1, 4) and moved > 1e-6:
        wanted = f"in stage {old} the robot turns on the spot"
        raise Wrong(wanted, f"it moves by {moved:.4f} m", share=0.3, hint=1, at=at)


def judge_stage(stage: int, begin: Spot, end: Spot, goal: Spot, steps: int) -> None:
    """Raise Wrong unless a stage ends at its goal, in the minimum number of steps."""
    at = [end[:2]]
    if stage in (1, 4):
        off, whole, what = math.dist(end[:2], goal[:2]), math.dist(begin[:2], goal[:2]) / STEP, "place"
    else:
        aim = math.atan2(goal[1] - begin[1], goal[0] - begin[0]) if stage in (0, 3) else goal[2]
        off = abs(math.remainder(end[2] - aim, math.tau))
        whole, what = abs(math.remainder(begin[2] - aim, math.tau)) / TURN, "yaw"
    unit = "m" if what == "place" else "rad"
    if off > 1e-4:
        cause = "The last, shorter step has to end at the goal." if off < TURN * 1.1 else "To which of the two poses?"
        if steps < whole - 1.5 and near(off / (STEP if what == "place" else TURN), whole - steps, 0.01):
            cause = "The next stage comes too early: only when nothing is left, this one is over."
        raise Wrong(f"stage {stage} ends exactly at its {what}", f"{off:.3f} {unit} beside it", cause, share=0.4, at=at)
    if steps > whole + 2.5:
        cause = "Does it turn the longer way round?" if what == "yaw" else "Are the steps too small?"
        raise Wrong(f"stage {stage} takes {math.ceil(whole)} steps", f"{steps} steps", cause, share=0.5, at=at)
