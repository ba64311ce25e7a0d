"""Names of Matplotlib 3.5, which a robot with Humble has, for programs that meet a newer Matplotlib here.

Mostly what programs of that time do in a plot: 3D axes from `gca(projection="3d")`, a marker moved by two numbers, a grid
by `b=True`, colours by `cm.get_cmap`, the picture of a figure by `tostring_rgb`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import wraps
from typing import Any

import matplotlib
import numpy as np
from matplotlib import cm, style
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.contour import ContourSet
from matplotlib.figure import Figure
from matplotlib.legend import Legend

from coursekit.processes.older_names import Name, adding
from coursekit.processes.patching import IMPORTS, Change, Patch

_STYLES = "seaborn-v0_8"


def get_cmap(name: Any = None, lut: int | None = None) -> Any:
    """Return a colour map, with `lut` colours if told."""
    if name is not None and not isinstance(name, str):
        return name
    found = matplotlib.colormaps[name or matplotlib.rcParams["image.cmap"]]
    return found if lut is None else found.resampled(lut)


def _tostring_rgb(canvas: FigureCanvasAgg) -> bytes:
    return np.asarray(canvas.buffer_rgba())[..., :3].tobytes()


def _set_window_title(canvas: FigureCanvasAgg, title: str) -> None:
    if canvas.manager is not None:
        canvas.manager.set_window_title(title)


def _remove_at(artists: Any, index: int = -1) -> Any:
    artist = artists[index]
    artist.remove()
    return artist


def _remove(_artists: Any, artist: Any) -> None:
    artist.remove()


def _clear(artists: Any) -> None:
    for artist in list(artists):
        artist.remove()


def _names() -> Iterator[Name]:
    yield cm, "get_cmap", get_cmap
    yield FigureCanvasAgg, "tostring_rgb", _tostring_rgb
    yield FigureCanvasAgg, "set_window_title", _set_window_title
    yield Legend, "legendHandles", property(lambda legend: legend.legend_handles)
    # One item for all levels, where 3.5 has one for each: enough to remove, hide or recolour a drawing.
    yield ContourSet, "collections", property(lambda contours: [contours])
    for name, function in (("pop", _remove_at), ("remove", _remove), ("clear", _clear)):
        yield Axes.ArtistList, name, function


def _add_styles(_found: Any) -> Callable[[], None]:
    """Give the styles their names of 3.5, `seaborn-whitegrid` for `seaborn-v0_8-whitegrid`; return what takes them away."""
    older = {name.replace(_STYLES, "seaborn"): name for name in list(style.library) if name.startswith(_STYLES)}
    mine = {name: style.library[newer] for name, newer in older.items() if name not in style.library}
    style.library.update(mine)

    def remove() -> None:
        for name in mine:
            style.library.pop(name, None)

    return remove


def _gca(real: Callable[..., Any]) -> Callable[..., Any]:
    """Return `Figure.gca`, to which 3.5 could tell what kind of axes it is to make."""

    @wraps(real)
    def gca(self: Figure, **wanted: Any) -> Any:
        kind = wanted.get("projection") or ("polar" if wanted.get("polar") else "rectilinear")
        if not wanted or (self.axes and real(self).name == kind):
            return real(self)
        return self.add_subplot(1, 1, 1, **wanted)

    return gca


def _pyplot_gca(real: Callable[..., Any]) -> Callable[..., Any]:
    from matplotlib import pyplot as plt  # not above: pyplot's import brings this module

    return wraps(real)(lambda **wanted: plt.gcf().gca(**wanted))


def _grid(real: Callable[..., Any]) -> Callable[..., Any]:
    """Return `Axes.grid`, whose first parameter was called `b`."""

    @wraps(real)
    def grid(self: Axes, visible: Any = None, which: str = "major", axis: str = "both", **lines: Any) -> Any:
        return real(self, lines.pop("b", visible), which, axis, **lines)

    return grid


def _stem(real: Callable[..., Any]) -> Callable[..., Any]:
    """Return `stem`, of the axes or of pyplot, without an option that every program of that time gave."""
    return wraps(real)(lambda *places, use_line_collection=True, **named: real(*places, **named))


def _number_too(real: Callable[[Any, Any], None]) -> Callable[[Any, Any], None]:
    """Return `set_xdata` or its like, to which 3.5 could give one number for a line of one point."""
    return wraps(real)(lambda self, values: real(self, values if np.iterable(values) else [values]))


_TEST, _REASON = "tests/view/test_older_matplotlib.py", "programs for Humble's Matplotlib 3.5 draw their plots"
_AXES, _FIGURE, _LINE = "matplotlib.axes._axes.Axes", "matplotlib.figure.FigureBase", "matplotlib.lines.Line2D"
PATCHES: tuple[Patch, ...] = (
    Change("matplotlib (older names)", adding(_names), _REASON, _TEST, IMPORTS),
    Change("matplotlib.style.library (older names)", _add_styles, _REASON, _TEST, IMPORTS),
    Patch(f"{_FIGURE}.gca", _gca, _REASON, _TEST, IMPORTS),
    Patch("matplotlib.axes._base._AxesBase.grid", _grid, _REASON, _TEST, IMPORTS),
    Patch("matplotlib.pyplot.gca", _pyplot_gca, _REASON, _TEST, IMPORTS),
    Patch(f"{_AXES}.stem", _stem, _REASON, _TEST, IMPORTS),
    Patch("matplotlib.pyplot.stem", _stem, _REASON, _TEST, IMPORTS),
    Patch(f"{_LINE}.set_xdata", _number_too, _REASON, _TEST, IMPORTS),
    Patch(f"{_LINE}.set_ydata", _number_too, _REASON, _TEST, IMPORTS),
)
