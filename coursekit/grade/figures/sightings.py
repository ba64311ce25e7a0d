"""The positions that a program finds in images, beside the true ones."""

from __future__ import annotations

import math
from collections.abc import Mapping

from coursekit.view.figure import Dots, Figure, Line, Panel, Point, Shape


def seen_at(places: Mapping[int, Point], answers: Mapping[int, Point], size: tuple[int, int], near: float) -> Figure:
    """Draw all images in one, `size` pixels wide and high: the ball, and the answers, which are wrong beyond `near`."""
    pairs = [(places[number], answer) for number, answer in answers.items() if number in places]
    right, wrong = ([pair for pair in pairs if (math.dist(*pair) <= near) is is_near] for is_near in (True, False))
    shapes: list[Shape] = [Line(pair, "bad", "how far off") for pair in wrong]
    shapes.append(Dots(list(places.values()), "truth", "the ball", 5.5))
    shapes.append(Dots([answer for _, answer in right], "own", "your place", 2.8))
    shapes.append(Dots([answer for _, answer in wrong], "bad", "a place beside it", 3.5))
    alt = f"{len(places)} pictures of {size[0]} x {size[1]} pixels in one: {len(pairs)} answers, {len(wrong)} far off."
    return Figure([Panel(shapes, view=(0.0, float(size[0]), 0.0, float(size[1])), down=True)], alt)


__all__ = ["seen_at"]
