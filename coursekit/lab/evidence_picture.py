"""Evidence as a picture: the shown objects from top to bottom, below a line with the name, place and time."""

from __future__ import annotations

import base64
import io
from collections.abc import Sequence
from typing import Any

WIDTH = 9.0
"""The page width in inches."""
PART = 0.96
"""The fraction of the page width that a part takes."""
DPI = 120
_COLUMNS_OF_PART = round(PART * WIDTH * DPI)
LINE = 0.17
"""The height of a text line in inches."""
MOST_LINES = 60
_COLUMNS = 110


def page(heading: str, things: Sequence[Any], kind: str) -> bytes:
    """Return a PNG or PDF (`kind`) of all `things` below the heading."""
    from matplotlib.figure import Figure

    parts = [_part(thing) for thing in things]
    heights = [0.4, *(_height(part) for part in parts)]
    total = sum(heights) + 0.15 * len(heights)
    figure: Any = Figure(figsize=(WIDTH, total), dpi=DPI, facecolor="white")
    figure.text(0.02, 1 - 0.25 / total, heading, fontsize=10, weight="bold", va="center", parse_math=False)
    below = heights[0] + 0.15
    for part, height in zip(parts, heights[1:], strict=True):
        axes = figure.add_axes((0.02, 1 - (below + height) / total, PART, height / total))
        axes.axis("off")
        if isinstance(part, str):
            axes.text(0, 1, part, fontsize=8, family="monospace", va="top", transform=axes.transAxes, parse_math=False)
        else:
            axes.imshow(part, interpolation="nearest" if part.shape[1] == _COLUMNS_OF_PART else "antialiased")
        below += height + 0.15
    file = io.BytesIO()
    dates = {"CreationDate": None} if kind == "pdf" else {}
    figure.savefig(file, format=kind, metadata={"Title": heading, **dates})
    return file.getvalue()


def _part(thing: Any) -> Any:
    """Return an image (rows, columns, channels), or text."""
    data = _image_bytes(thing)
    if data is None:
        lines = [line[at : at + _COLUMNS] for line in _text(thing).splitlines() for at in range(0, len(line) or 1, _COLUMNS)]
        return "\n".join(lines[-MOST_LINES:]) or "(nothing)"
    import cv2
    import numpy as np

    image = cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_COLOR)
    if image is None:
        raise ValueError("its picture cannot be read")
    rows, columns = image.shape[:2]
    if columns > _COLUMNS_OF_PART:  # OpenCV scales quickly; matplotlib takes a second
        size = (_COLUMNS_OF_PART, max(1, round(rows * _COLUMNS_OF_PART / columns)))
        image = cv2.resize(image, size, interpolation=cv2.INTER_AREA)
    return cv2.cvtColor(image, cv2.COLOR_BGR2RGB)


def _image_bytes(thing: Any) -> bytes | None:
    if hasattr(thing, "snapshot"):
        thing = thing.snapshot()
    picture = getattr(thing, "picture", None)
    if callable(getattr(picture, "png", None)):
        thing = picture
    for name in ("png", "_repr_png_"):
        if callable(getattr(thing, name, None)):
            return bytes(getattr(thing, name)())
    mimebundle = thing._repr_mimebundle_() if hasattr(thing, "_repr_mimebundle_") else {}
    bundle = mimebundle[0] if isinstance(mimebundle, tuple) else mimebundle
    for kind in ("image/png", "image/jpeg"):
        if kind in (bundle or {}):
            data = bundle[kind]
            return data if isinstance(data, bytes) else base64.b64decode(data)
    return None


def _text(thing: Any) -> str:
    text = getattr(thing, "text", None)
    said = text() if callable(text) else text
    shown = said if isinstance(said, str) else thing if isinstance(thing, str) else repr(thing)
    title = getattr(thing, "title", "")
    return f"$ {title}\n{shown}" if isinstance(title, str) and title else shown


def _height(part: Any) -> float:
    if isinstance(part, str):
        return LINE * (part.count("\n") + 1) + 0.1
    rows, columns = part.shape[:2]
    return float(min(PART * WIDTH * rows / columns, 8.0))
