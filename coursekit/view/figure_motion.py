"""Motion in a figure as CSS rules: nothing moves until the reader ticks the box above it."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence

from coursekit.words.gettext import gettext

Point = tuple[float, float]
MOST_STEPS = 400
"""The maximum number of positions kept; longer paths are thinned out."""
TICK, SHORTEST, LONGEST = 0.15, 4.0, 30.0
"""The seconds per tick, and the minimum and maximum for the whole path."""


def box() -> str:
    """Return the checkbox that starts the motion."""
    return f'<label class="drawn-play"><input type="checkbox">{gettext("see them move")}</label>'


def moving(places: Sequence[Point], kind: str, ticks: int) -> str:
    """Draw a dot that moves along these pixels repeatedly, in the time of `ticks` positions.

    The name of its CSS rule is a hash of its content, so the same path always gives the same text.
    """
    corners = _corners(places, ticks)
    frames = "".join(f"{share:.4g}%{{transform:translate({x:.1f}px,{y:.1f}px)}}" for share, (x, y) in corners)
    name = "ck" + hashlib.sha256(frames.encode()).hexdigest()[:12]
    seconds = min(max(TICK * ticks, SHORTEST), LONGEST)
    run = f".ck-drawn:has(input:checked) .{name}{{animation:{name} {seconds:.1f}s linear infinite}}"
    return f'<style>@keyframes {name}{{{frames}}}{run}</style><circle class="fill mover {kind} {name}" r="7"/>'


def _corners(places: Sequence[Point], ticks: int) -> list[tuple[float, Point]]:
    """Return the corners of the path with their share of the time [%]; at its end it waits for the others."""
    step = -(-len(places) // MOST_STEPS)
    kept = [(at, places[at]) for at in range(0, len(places), step)]
    if kept[-1][0] != len(places) - 1:
        kept.append((len(places) - 1, places[-1]))
    inner = [
        corner
        for before, corner, after in zip(kept, kept[1:], kept[2:], strict=False)
        if not _straight(before, corner, after)
    ]
    corners = [kept[0], *inner, kept[-1]]
    timed = [(95.0 * at / max(1, ticks - 1), place) for at, place in corners]
    return [*timed, (100.0, places[-1])]


def _straight(before: tuple[int, Point], corner: tuple[int, Point], after: tuple[int, Point]) -> bool:
    """Whether the middle position is the one that interpolation gives anyway."""
    part = (corner[0] - before[0]) / (after[0] - before[0])
    wish = (x + part * (to - x) for x, to in zip(before[1], after[1], strict=True))
    return all(abs(there - here) < 0.05 for there, here in zip(wish, corner[1], strict=True))


__all__ = ["box", "moving"]
