"""A drawing as PNG or PDF bytes, by matplotlib's canvases (no pyplot, no window)."""

from __future__ import annotations

import io
from collections.abc import Callable
from typing import Any

from .drawing import Curve, Drawing, Rect, Text, bends, heads

SCALE = 2.0
"""Image pixels for each pixel of the drawing, for high-resolution screens."""
MANY_SHAPES = 600
"""The number of shapes above which OpenCV draws, because matplotlib would take seconds."""


def png(drawing: Drawing) -> bytes:
    """Return the picture, `SCALE` times as large as the drawing; a huge one is plainer and coarser."""
    if sum(len(part.shapes) for part in drawing.parts) > MANY_SHAPES:
        from . import drawing_fast

        return drawing_fast.png(drawing, SCALE)
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    file = io.BytesIO()
    FigureCanvasAgg(_figure(drawing)).print_png(file)
    return file.getvalue()


def pdf(drawing: Drawing) -> bytes:
    """Return the picture as a PDF page of its size; deterministic."""
    from matplotlib.backends.backend_pdf import FigureCanvasPdf

    file = io.BytesIO()
    FigureCanvasPdf(_figure(drawing)).print_pdf(file, metadata={"CreationDate": None})
    return file.getvalue()


def _figure(drawing: Drawing) -> Any:
    from matplotlib.figure import Figure

    figure = Figure(
        figsize=(drawing.width / 72, drawing.height / 72), dpi=72 * SCALE, facecolor=drawing.background
    )
    axes: Any = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_xlim(0, drawing.width)
    axes.set_ylim(drawing.height, 0)
    axes.axis("off")
    draw: dict[type, Callable[[Any, Any], None]] = {Rect: _rect, Text: _text, Curve: _curve}
    for part in drawing.parts:
        for shape in part.shapes:
            draw[type(shape)](axes, shape)
    return figure


def _rect(axes: Any, rect: Rect) -> None:
    from matplotlib.patches import FancyBboxPatch

    radius = min(rect.radius, rect.height / 2, rect.width / 2)
    axes.add_patch(
        FancyBboxPatch(
            (rect.x, rect.y),
            rect.width,
            rect.height,
            boxstyle=f"round,pad=0,rounding_size={radius}",
            facecolor=rect.fill,
            edgecolor=rect.stroke,
            linewidth=rect.line,
            linestyle=(0, (4, 3)) if rect.dashed else "-",
        )
    )


def _text(axes: Any, text: Text) -> None:
    side = {"start": "left", "middle": "center"}[text.anchor]
    weight = "bold" if text.bold else "normal"
    axes.text(
        text.x,
        text.y,
        text.text.replace("$", r"\$"),
        fontsize=text.size * 0.94,
        color=text.fill,
        ha=side,
        va="baseline",
        fontweight=weight,
    )


def _curve(axes: Any, curve: Curve) -> None:
    from matplotlib.patches import PathPatch, Polygon
    from matplotlib.path import Path

    points = [curve.points[0], *(point for piece in bends(curve.points) for point in piece)]
    codes = [Path.MOVETO] + [Path.CURVE4] * (len(points) - 1)
    style = (0, (4, 3)) if curve.dashed else "-"
    axes.add_patch(
        PathPatch(
            Path(points, codes), fill=False, edgecolor=curve.stroke, linewidth=curve.line, linestyle=style
        )
    )
    for corners in heads(curve):
        axes.add_patch(Polygon(corners, closed=True, facecolor=curve.stroke, edgecolor="none"))
