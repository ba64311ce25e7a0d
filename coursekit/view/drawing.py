"""A picture as a list of shapes, written as SVG here and as PNG in `drawing_png`."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, field
from html import escape

Point = tuple[float, float]
FONT = "system-ui, -apple-system, 'Segoe UI', Roboto, 'DejaVu Sans', sans-serif"
_NARROW = {
    **dict.fromkeys("ijl.,:;'|!", 0.29),
    **dict.fromkeys("/()[]{}ft -r", 0.39),
    **dict.fromkeys("mwMW%@", 0.92),
}


def text_width(text: str, size: float) -> float:
    """Estimate the width of a text in pixels, rather too large for common fonts.

    >>> text_width("ii", 10) < text_width("mm", 10)
    True
    """
    return sum(_NARROW.get(letter, 0.7 if letter.isupper() else 0.62) for letter in text) * size


@dataclass(frozen=True)
class Rect:
    """A rectangle with rounded corners."""

    x: float
    y: float
    width: float
    height: float
    radius: float
    fill: str
    stroke: str
    line: float = 1.2
    dashed: bool = False
    kind: str = ""


@dataclass(frozen=True)
class Curve:
    """A smooth line through points; `heads` draws arrow heads: 'end', 'both' or ''."""

    points: tuple[Point, ...]
    stroke: str
    heads: str = "end"
    line: float = 1.4
    dashed: bool = False
    kind: str = ""
    ends: tuple[str, str] = ("", "")


@dataclass(frozen=True)
class Text:
    """A line of text; `anchor` is 'start' or 'middle', y the baseline."""

    x: float
    y: float
    text: str
    size: float
    fill: str
    anchor: str = "start"
    bold: bool = False
    kind: str = ""


@dataclass(frozen=True)
class Part:
    """Shapes that form one object, such as a node or a topic; `name` identifies it when it is clicked."""

    shapes: tuple[Rect | Text | Curve, ...]
    name: str = ""
    tip: str = ""


@dataclass
class Drawing:
    """Shapes from back to front; sizes in pixels."""

    width: float
    height: float
    parts: list[Part] = field(default_factory=list)
    background: str = "#ffffff"

    def add(self, *shapes: Rect | Text | Curve, name: str = "", tip: str = "") -> None:
        """Add shapes on top."""
        self.parts.append(Part(shapes, name, tip))


def svg(drawing: Drawing, title: str = "") -> str:
    """Return the picture as SVG text; deterministic."""
    width, height = _n(drawing.width), _n(drawing.height)
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
        f'font-family="{FONT}" role="img" aria-label="{escape(title)}">',
        f'<rect class="ck-paper" width="{width}" height="{height}" rx="10" fill="{drawing.background}"/>',
    ]
    for part in drawing.parts:
        inner = "".join(_shape(shape) for shape in part.shapes)
        if part.name:
            tip = f"<title>{escape(part.tip or part.name)}</title>"
            inner = f'<g class="ck-part" data-name="{escape(part.name)}" tabindex="0" role="button">{tip}{inner}</g>'
        lines.append(inner)
    return "\n".join([*lines, "</svg>"])


def _shape(shape: Rect | Text | Curve) -> str:
    return {Rect: _rect, Text: _text, Curve: _curve}[type(shape)](shape)  # type: ignore[operator]


def _n(number: float) -> str:
    return f"{number:.1f}".removesuffix(".0")


def _rect(r: Rect) -> str:
    dash = ' stroke-dasharray="5 4"' if r.dashed else ""
    return (
        f'<rect class="{r.kind}" x="{_n(r.x)}" y="{_n(r.y)}" width="{_n(r.width)}" height="{_n(r.height)}" '
        f'rx="{_n(r.radius)}" fill="{r.fill}" stroke="{r.stroke}" stroke-width="{_n(r.line)}"{dash}/>'
    )


def _text(t: Text) -> str:
    weight = ' font-weight="600"' if t.bold else ""
    anchor = "" if t.anchor == "start" else f' text-anchor="{t.anchor}"'
    return (
        f'<text class="{t.kind}" x="{_n(t.x)}" y="{_n(t.y)}" font-size="{_n(t.size)}" fill="{t.fill}"{anchor}{weight}>'
        f"{escape(t.text)}</text>"
    )


def _curve(c: Curve) -> str:
    dash = ' stroke-dasharray="5 4"' if c.dashed else ""
    ends = f' data-from="{escape(c.ends[0])}" data-to="{escape(c.ends[1])}"' if c.ends != ("", "") else ""
    path = (
        f'<path class="ck-line-path" d="{path_of(c.points)}" fill="none" stroke="{c.stroke}" '
        f'stroke-width="{_n(c.line)}"{dash}/>'
    )
    return f'<g class="{c.kind}"{ends}>{path}{"".join(_head(tip, c.stroke) for tip in heads(c))}</g>'


def bends(points: Sequence[Point]) -> list[tuple[Point, Point, Point]]:
    """Return the cubic pieces of a curve, horizontal at both ends: two control points and the end of each.

    >>> bends([(0.0, 0.0), (10.0, 4.0)])
    [((5.0, 0.0), (5.0, 4.0), (10.0, 4.0))]
    """
    pieces = []
    for (x0, y0), (x1, y1) in itertools.pairwise(points):
        reach = (x1 - x0) * 0.5
        pieces.append(((x0 + reach, y0), (x1 - reach, y1), (x1, y1)))
    return pieces


def path_of(points: Sequence[Point]) -> str:
    """Return the SVG path of a curve.

    >>> path_of([(0.0, 0.0), (10.0, 4.0)])
    'M0 0 C5 0 5 4 10 4'
    """
    text = f"M{_n(points[0][0])} {_n(points[0][1])}"
    for piece in bends(points):
        text += " C" + " ".join(f"{_n(x)} {_n(y)}" for x, y in piece)
    return text


def heads(curve: Curve) -> list[tuple[Point, Point, Point]]:
    """Return the triangles of a curve's arrow heads."""
    heads = []
    if curve.heads in ("end", "both"):
        heads.append(_triangle(curve.points[-1], curve.points[-2]))
    if curve.heads == "both":
        heads.append(_triangle(curve.points[0], curve.points[1]))
    return heads


def _triangle(tip: Point, before: Point) -> tuple[Point, Point, Point]:
    back = -8.0 if tip[0] >= before[0] else 8.0
    return tip, (tip[0] + back, tip[1] - 3.6), (tip[0] + back, tip[1] + 3.6)


def _head(corners: tuple[Point, Point, Point], colour: str) -> str:
    points = " ".join(f"{_n(x)},{_n(y)}" for x, y in corners)
    return f'<polygon class="ck-head" points="{points}" fill="{colour}"/>'
