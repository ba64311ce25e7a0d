"""The base of what has a picture and a text: its forms, and what a notebook stores of it."""

from __future__ import annotations

from typing import Any

from .drawing import Drawing, svg
from .drawing_png import png


class Drawn:
    """A notebook stores the text, which tests compare, and the picture as PNG, which they do not."""

    title = ""
    """The title of the SVG."""

    def drawing(self) -> Drawing:
        """Return the picture's shapes."""
        raise NotImplementedError

    def text(self) -> str:
        """Return the same as text."""
        raise NotImplementedError

    def svg(self) -> str:
        """Return the picture as SVG."""
        return svg(self.drawing(), title=self.title)

    def png(self) -> bytes:
        """Return the picture as PNG, at twice the size of the SVG."""
        return png(self.drawing())

    def __repr__(self) -> str:
        return self.text()

    def _repr_mimebundle_(self, **_options: Any) -> tuple[dict[str, Any], dict[str, Any]]:
        drawing = self.drawing()
        size = {"width": round(drawing.width), "height": round(drawing.height)}
        return {"text/plain": self.text(), "image/png": png(drawing)}, {"image/png": size}


__all__ = ["Drawn"]
