"""A figure as HTML: SVG whose colours follow the page, its legend below, and its alternative text."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass
from html import escape

import numpy as np

from coursekit.words.gettext import gettext

from .figure import FARTHEST, Arrow, Cells, Dots, Figure, Line, Mover, Panel, Point, Shape, View, Words, drawable, view_of
from .figure_motion import box, moving
from .figure_style import style

WIDTHS = {1: 520.0, 2: 350.0, 3: 250.0}
"""The width of a panel, by the number of panels [pixels]."""
TALLEST, CHART = 340.0, 210.0
RIGHT, MOST_RINGS = 18, 24


def html(figure: Figure) -> str:
    """Return the figure as a part of a page; deterministic, without other files or scripts."""
    wide = WIDTHS.get(len(figure.panels), 220.0)
    panels = "".join(_panel(panel, wide) for panel in figure.panels)
    legend = "".join(_legend(figure))
    return (
        f'<figure class="ck-drawn"><style>{style()}</style>{box() if "mover" in panels else ""}'
        f'<div class="drawn-parts" role="img" aria-label="{escape(gettext(figure.alt))}">{panels}</div>'
        f"{f'<figcaption>{legend}</figcaption>' if legend else ''}</figure>"
    )


def _panel(panel: Panel, wide: float) -> str:
    view = view_of(panel)
    frame = _Frame.of(panel, view, wide)
    width, height = _n(frame.width), _n(frame.height)
    is_map = not panel.axes and any(isinstance(shape, Cells) for shape in panel.shapes)
    paper = "unknown" if is_map else "free"
    back = f'<rect class="fill {paper}" width="{width}" height="{height}"/>'
    inner = "".join(_draw(shape, frame) for shape in panel.shapes if not isinstance(shape, Mover))
    inner += "".join(_movers([shape for shape in panel.shapes if isinstance(shape, Mover)], frame))
    grid = "".join(_grid(view, frame, panel.axes)) if panel.axes else ""
    rings = "".join(_ring(at, frame) for at in drawable(panel.rings)[:MOST_RINGS])
    title = f'<p class="drawn-title">{escape(gettext(panel.title))}</p>' if panel.title else ""
    size = f'width="{width}" height="{height}" viewBox="0 0 {width} {height}"'
    return f'<div class="drawn-part">{title}<svg {size} aria-hidden="true">{back}{grid}{inner}{rings}</svg></div>'


@dataclass(frozen=True)
class _Frame:
    """The mapping from units to pixels: `scale` of each axis, and the pixel of the view's lower left corner."""

    width: float
    height: float
    scale: Point
    begin: Point
    left: float
    low: float

    @classmethod
    def of(cls, panel: Panel, view: View, wide: float) -> _Frame:
        """Return the frame of a panel that is at most `wide` pixels wide."""
        left, right, low, high = view
        across, up = max(right - left, 1e-9), max(high - low, 1e-9)
        if panel.axes:
            room = (46.0, 34.0)
            scale = ((wide - room[0] - RIGHT) / across, -(CHART - room[1] - 22) / up)
            return cls(wide, CHART, scale, (room[0], CHART - room[1]), left, low)
        zoom = min(wide / across, TALLEST / up)
        width, height = max(across * zoom, 40.0), max(up * zoom, 40.0)
        if panel.down:
            return cls(width, height, (zoom, zoom), (0.0, 0.0), left, low)
        return cls(width, height, (zoom, -zoom), (0.0, height), left, low)

    def at(self, x: float, y: float) -> Point:
        """Return the pixel of a point."""
        return self.begin[0] + (x - self.left) * self.scale[0], self.begin[1] + (y - self.low) * self.scale[1]


def _n(number: float) -> str:
    return f"{number + 0.0:.1f}".removesuffix(".0")


def _pairs(points: list[Point], frame: _Frame) -> str:
    return " ".join(f"{_n(x)},{_n(y)}" for x, y in (frame.at(*point) for point in points))


def _movers(movers: list[Mover], frame: _Frame) -> Iterator[str]:
    ticks = max((len(mover.places) for mover in movers), default=0)
    for mover in movers:
        if len(mover.places) > 1 and all(abs(x) < FARTHEST and abs(y) < FARTHEST for x, y in mover.places):
            yield moving([frame.at(*place) for place in mover.places], mover.kind, ticks)


def _draw(shape: Shape, frame: _Frame) -> str:
    if isinstance(shape, Cells):
        return "".join(_cells(shape, frame))
    if isinstance(shape, Line):
        extra = " dashed" * shape.dashed + " wide" * shape.wide
        points = drawable(shape.points)
        return f'<polyline class="line {shape.kind}{extra}" points="{_pairs(points, frame)}"/>' if points else ""
    if isinstance(shape, Dots):
        return _dots(shape, frame)
    if isinstance(shape, Mover) or not drawable([(shape.x, shape.y)]):
        return ""
    return _arrow(shape, frame) if isinstance(shape, Arrow) else _words(shape, frame)


def _dots(dots: Dots, frame: _Frame) -> str:
    """Draw one path of short strokes with round ends: much shorter than as many circles."""
    places = (frame.at(*point) for point in drawable(dots.points))
    path = "".join(f"M{_n(x)} {_n(y)}h0" for x, y in places)
    return f'<path class="line {dots.kind}" style="stroke-width:{_n(2 * dots.radius)}" d="{path}"/>' if path else ""


def _cells(cells: Cells, frame: _Frame) -> Iterator[str]:
    """Draw a path for each kind, made of its runs along the rows."""
    for code, kind in enumerate(cells.kinds):
        path = "".join(_run(cells, frame, *run) for run in _runs(cells.codes == code))
        if path:
            yield f'<path class="fill {kind}" shape-rendering="crispEdges" d="{path}"/>'


def _runs(mask: np.ndarray) -> Iterator[tuple[int, int, int]]:
    """Yield (row, first column, column after the last) for each run of true cells."""
    edges = np.diff(np.pad(mask.astype(np.int8), ((0, 0), (1, 1))), axis=1)
    for row in range(len(mask)):
        begins, ends = np.flatnonzero(edges[row] == 1), np.flatnonzero(edges[row] == -1)
        yield from ((row, int(begin), int(end)) for begin, end in zip(begins, ends, strict=True))


def _run(cells: Cells, frame: _Frame, row: int, begin: int, end: int) -> str:
    (x, y), size = cells.corner, cells.size
    left, one = frame.at(x + begin * size, y + row * size)
    right, other = frame.at(x + end * size, y + (row + 1) * size)
    return f"M{_n(left)} {_n(one)}H{_n(right)}V{_n(other)}H{_n(left)}z"


def _arrow(arrow: Arrow, frame: _Frame) -> str:
    x, y = frame.at(arrow.x, arrow.y)
    turn = arrow.heading if frame.scale[1] > 0 else -arrow.heading
    corners = [(11.0, 0.0), (-7.0, 6.5), (-3.5, 0.0), (-7.0, -6.5)]
    c, s = math.cos(turn), math.sin(turn)
    points = " ".join(f"{_n(x + c * u - s * v)},{_n(y + s * u + c * v)}" for u, v in corners)
    return f'<polygon class="halo" points="{points}"/><polygon class="fill {arrow.kind}" points="{points}"/>'


def _words(words: Words, frame: _Frame) -> str:
    x, y = frame.at(words.x, words.y)
    side, shift = ("end", -8) if words.before or x > frame.width - 60 else ("start", 8)
    text = escape(gettext(words.text))
    return f'<text class="{words.kind}" x="{_n(x + shift)}" y="{_n(y + 4)}" text-anchor="{side}">{text}</text>'


def _ring(place: Point, frame: _Frame) -> str:
    x, y = frame.at(*place)
    x, y = min(max(x, 10.0), frame.width - 10.0), min(max(y, 10.0), frame.height - 10.0)
    return f'<circle class="ring" cx="{_n(x)}" cy="{_n(y)}" r="9"/>'


def _grid(view: View, frame: _Frame, names: tuple[str, str]) -> Iterator[str]:
    """Draw the lines and numbers of a chart, and the names of its axes."""
    left, right, low, high = view
    for value in _ticks(low, high, 4) if names[1] else ():
        x, y = frame.at(left, value)
        yield f'<path class="line rim" style="stroke-width:1" d="M{_n(x)} {_n(y)}H{_n(frame.width - RIGHT)}"/>'
        yield f'<text class="ink" x="{_n(x - 6)}" y="{_n(y + 4)}" text-anchor="end">{value:g}</text>'
    for value in _ticks(left, right, 6):
        x, y = frame.at(value, low)
        yield f'<text class="ink" x="{_n(x)}" y="{_n(y + 14)}" text-anchor="middle">{value:g}</text>'
    x, y = frame.width - RIGHT, frame.height - 5
    yield f'<text class="ink" x="{_n(x)}" y="{_n(y)}" text-anchor="end">{escape(gettext(names[0]))}</text>'
    yield f'<text class="ink" x="6" y="13">{escape(gettext(names[1]))}</text>'


def _ticks(low: float, high: float, most: int) -> list[float]:
    """Return round numbers from `low` to `high`.

    >>> _ticks(0.0, 2.2, 4)
    [0.0, 1.0, 2.0]
    """
    rough = max(high - low, 1e-9) / most
    ten = 10.0 ** math.floor(math.log10(rough))
    step = next(step * ten for step in (1, 2, 5, 10) if step * ten >= rough - 1e-12)
    return [round(k * step, 9) + 0.0 for k in range(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1)]


def _legend(figure: Figure) -> Iterator[str]:
    """Yield each label once, in drawing order."""
    seen: set[str] = set()
    for sign, kind, label in itertools.chain.from_iterable(map(_keys, (shape for p in figure.panels for shape in p.shapes))):
        if label and label not in seen:
            seen.add(label)
            yield f'<span class="drawn-key"><i class="{sign} {kind}"></i>{escape(gettext(label))}</span>'
    if any(panel.rings for panel in figure.panels):
        yield f'<span class="drawn-key"><i class="round"></i>{gettext("what is wrong")}</span>'


def _keys(shape: Shape) -> Iterator[tuple[str, str, str]]:
    """Yield (sign, kind, label) for the visible parts of a shape."""
    if isinstance(shape, Cells):
        there = set(np.unique(shape.codes).tolist())
        named = enumerate(zip(shape.kinds, shape.labels, strict=False))
        yield from (("cell", *pair) for code, pair in named if code in there)
    elif isinstance(shape, Arrow) or (isinstance(shape, (Line, Dots)) and len(shape.points) > isinstance(shape, Line)):
        sign = ("dash" if shape.dashed else "stroke") if isinstance(shape, Line) else "dot"
        yield sign, shape.kind, shape.label


__all__ = ["html"]
