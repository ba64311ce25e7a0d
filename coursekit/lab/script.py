"""The browser's side of a widget, as one text: what several share, its own, and the veil over what has ended."""

from __future__ import annotations

from pathlib import Path

_STATIC = Path(__file__).parent / "static"
_EXPORT = "export default {"


def script(*names: str) -> str:
    """The files of `static/` one after the other; the last exports the widget, which is veiled when its program is gone."""
    veil, *parts = ((_STATIC / name).read_text(encoding="utf-8") for name in ("veil.js", *names))
    own = "\n".join(parts)
    assert own.count(_EXPORT) == 1, f"{names[-1]} has to export one widget: {_EXPORT} ... }};"
    return f"{veil}\n{own.replace(_EXPORT, 'const widget = {')}\nexport default veiled(widget);\n"


def style(*names: str) -> str:
    """The style sheets of `static/` one after the other."""
    return "\n".join((_STATIC / name).read_text(encoding="utf-8") for name in names)


__all__ = ["script", "style"]
