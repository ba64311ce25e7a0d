"""Motion in a figure, as rules of CSS: nothing moves until the reader ticks the box above it."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence

from coursekit.words.gettext import gettext

Point = tuple[float, float]
MOST_STEPS = 400
"""Of longer ways every so-manieth place is kept."""
TICK, SHORTEST, LONGEST = 0.15, 4.0, 30.0
"""Seconds for each tick, and for the whole way at least and at most."""


def box() -> str:
    """The box that the reader ticks to see them move."""
    return f'<label class="drawn-play"><input type="checkbox">{gettext("see them move")}</label>'


def moving(places: Sequence[Point], kind: str, ticks: int) -> str:
    """A dot that is at these pixels one after the other, over and over; it takes the time of `ticks` places.

    The name of its rule is made of what it says, so the same way always gives the same text.
    """
    corners = _corners(places, ticks)
    frames = "".join(f"{share:.4g}%{{transform:translate({x:.1f}px,{y:.1f}px)}}" for share, (x, y) in corners)
    name = "ck" + hashlib.sha256(frames.encode()).hexdigest()[:12]
    seconds = min(max(TICK * ticks, SHORTEST), LONGEST)
    run = f".ck-drawn:has(input:checked) .{name}{{animation:{name} {seconds:.1f}s linear infinite}}"
    return f'<style>@keyframes {name}{{{frames}}}{run}</style><circle class="fill mover {kind} {name}" r="7"/>'


def _corners(places: Sequence[Point], ticks: int) -> list[tuple[float, Point]]:
    """Where the way bends, stops or goes on, with the share of the time [%]; at its end it waits for the others."""
    step = -(-len(places) // MOST_STEPS)
    kept = [(at, places[at]) for at in range(0, len(places), step)]
    if kept[-1][0] != len(places) - 1:
        kept.append((len(places) - 1, places[-1]))
    inner = [one for before, one, after in zip(kept, kept[1:], kept[2:], strict=False) if not _straight(before, one, after)]
    corners = [kept[0], *inner, kept[-1]]
    found = [(95.0 * at / max(1, ticks - 1), place) for at, place in corners]
    return [*found, (100.0, places[-1])]


def _straight(before: tuple[int, Point], one: tuple[int, Point], after: tuple[int, Point]) -> bool:
    """Whether the place in the middle is where it would be anyway."""
    part = (one[0] - before[0]) / (after[0] - before[0])
    wish = (x + part * (to - x) for x, to in zip(before[1], after[1], strict=True))
    return all(abs(there - here) < 0.05 for there, here in zip(wish, one[1], strict=True))


__all__ = ["box", "moving"]
