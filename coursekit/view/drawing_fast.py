"""A drawing of hundreds of boxes as PNG bytes, by OpenCV: plainer than matplotlib's, but fast."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np

from .drawing import Curve, Drawing, Rect, Text, bends, heads, text_width

MOST_POINTS = 12e6
"""The maximum number of pixels in the picture."""
_FINE = 3
"""Fractional bits of coordinates for OpenCV: eighths of a pixel."""


def png(drawing: Drawing, scale: float) -> bytes:
    """Return the picture, `scale` times as large as the drawing, or smaller to stay below MOST_POINTS."""
    scale = min(scale, (MOST_POINTS / (drawing.width * drawing.height)) ** 0.5)
    size = round(drawing.height * scale), round(drawing.width * scale), 3
    image: np.ndarray = np.full(size, _colour(drawing.background), np.uint8)
    draw: dict[type, Any] = {Rect: _rect, Text: _text, Curve: _curve}
    for part in drawing.parts:
        for shape in part.shapes:
            draw[type(shape)](image, shape, scale)
    return bytes(cv2.imencode(".png", image, [cv2.IMWRITE_PNG_COMPRESSION, 3])[1])


def _colour(name: str) -> tuple[int, int, int]:
    """Convert '#rrggbb' to OpenCV's order, BGR."""
    red, green, blue = (int(name[at : at + 2], 16) for at in (1, 3, 5))
    return blue, green, red


def _points(points: Any, scale: float) -> np.ndarray:
    return np.round(np.asarray(points, float) * scale * 2**_FINE).astype(np.int32)


def _rect(image: np.ndarray, rect: Rect, scale: float) -> None:
    right, bottom = rect.x + rect.width, rect.y + rect.height
    cut = min(rect.radius, rect.height / 2, rect.width / 2) * 0.6
    outline = [(rect.x + cut, rect.y), (right - cut, rect.y), (right, rect.y + cut), (right, bottom - cut),
               (right - cut, bottom), (rect.x + cut, bottom), (rect.x, bottom - cut), (rect.x, rect.y + cut)]  # fmt: skip
    corners = _points(outline, scale)
    if rect.fill != "none":
        cv2.fillPoly(image, [corners], _colour(rect.fill), cv2.LINE_AA, _FINE)
    if rect.stroke != "none":
        cv2.polylines(image, [corners], True, _colour(rect.stroke), max(1, round(rect.line * scale)), cv2.LINE_AA, _FINE)


def _text(image: np.ndarray, text: Text, scale: float) -> None:
    font, thick = cv2.FONT_HERSHEY_SIMPLEX, 2 if text.bold and scale > 1 else 1
    said = text.text.replace("·", "-").encode("ascii", "replace").decode()
    width = text_width(text.text, text.size) * scale
    (wide, _), _ = cv2.getTextSize(said, font, 1.0, thick)
    left = text.x * scale - (width / 2 if text.anchor == "middle" else 0)
    size = width / max(wide, 1)
    cv2.putText(image, said, (round(left), round(text.y * scale)), font, size, _colour(text.fill), thick, cv2.LINE_AA)


def _curve(image: np.ndarray, curve: Curve, scale: float) -> None:
    share = np.linspace(0.0, 1.0, 13)[:, None]
    weights = np.hstack([(1 - share) ** 3, 3 * share * (1 - share) ** 2, 3 * share**2 * (1 - share), share**3])
    line, start = [np.asarray([curve.points[0]], float)], curve.points[0]
    for piece in bends(curve.points):
        line.append(weights[1:] @ np.asarray([start, *piece], float))
        start = piece[-1]
    colour = _colour(curve.stroke)
    cv2.polylines(
        image, [_points(np.vstack(line), scale)], False, colour, max(1, round(curve.line * scale)), cv2.LINE_AA, _FINE
    )
    for corners in heads(curve):
        cv2.fillPoly(image, [_points(corners, scale)], colour, cv2.LINE_AA, _FINE)


__all__ = ["png"]
