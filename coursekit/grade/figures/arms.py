"""A planar arm of two parts from above, with the tip position of an answer."""

from __future__ import annotations

import math
from collections.abc import Sequence

from coursekit.view.figure import Dots, Figure, Line, Panel, Shape


def arm(angles: Sequence[float], lengths: Sequence[float], tip: Sequence[float], answer: Sequence[float]) -> Figure:
    """Draw shoulder and elbow [rad], the two lengths [m], the tip and the answer's tip."""
    elbow = (lengths[0] * math.cos(angles[0]), lengths[0] * math.sin(angles[0]))
    right = math.dist(tip, answer) <= 1e-6
    shapes: list[Shape] = [Line([(0.0, 0.0), (0.4 * sum(lengths), 0.0)], "ink", "x", dashed=True)]
    shapes += [Line([(0.0, 0.0), elbow], "own", "upper arm", wide=True), Line([elbow, tip], "guess", "forearm", wide=True)]
    shapes += [Dots([(0.0, 0.0)], "ink", "shoulder", 5.0), Dots([elbow], "own", "elbow", 5.0)]
    shapes.append(Dots([tip], "truth", "tip", 5.0))
    if not right:
        shapes.append(Dots([answer], "bad", "your answer", 5.0))
    reach = 1.15 * sum(lengths)
    off = "your answer is its tip" if right else f"your answer is {math.dist(tip, answer):.2f} m from its tip"
    alt = f"An arm from above, its shoulder at {angles[0]:.2f} rad and its elbow at {angles[1]:.2f} rad; {off}."
    rings = [] if right else [(answer[0], answer[1])]
    return Figure([Panel(shapes, view=(-1.3 * reach, 1.3 * reach, -reach, reach), rings=rings)], alt)


__all__ = ["arm"]
