"""A map as a picture, with the true world and the driven paths."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import numpy as np

from coursekit.nav.map_file import GridMap, load_map
from coursekit.words.gettext import gettext

from .messages import listen
from .panel_node import HiddenNode
from .simulated import robot_name, simulator
from .tour import Tour

WAIT_SECONDS = 30.0
"""How long a map may take to arrive: where SLAM is compiled first, its first map takes half a minute [s]."""
SCAN_HEIGHT = 0.175
"""The default height at which the true world is cut [m]."""
_COLOURS = {"truth": "#16a34a", "odometry": "#ea7317", "SLAM": "#2563eb"}

_INK = "#76828c"
"""The colour of the scale: legible on light and dark pages."""


class MapView:
    """A map that was received or loaded; shows itself. `grid` has its cells, `comparison` its quality, if known."""

    def __init__(self, grid: GridMap, outline: np.ndarray | None, tour: Tour | None) -> None:
        from coursekit.nav.map_compare import compare  # SciPy takes half a second to import

        self.grid, self.outline, self.tour = grid, outline, tour
        self.comparison = None if outline is None else compare(grid, outline)

    def __repr__(self) -> str:
        cells = self.grid.cells
        rows, columns = cells.shape
        counts = f"{(cells > 65).sum()} walls, {((cells >= 0) & (cells <= 65)).sum()} free, {(cells < 0).sum()} unknown"
        lines = [f"map of {columns} x {rows} cells of {self.grid.resolution:g} m: {counts}"]
        return "\n".join(lines + ([str(self.comparison)] if self.comparison else []))

    def _repr_png_(self) -> bytes:
        return self.png(paper="none")  # the page may be light or dark

    def png(self, width: float = 8.0, paper: str = "white") -> bytes:
        """Return the picture, `width` inches wide: white free, black wall, grey unknown; the true walls in red.

        `paper` is the colour around the map; "none" is transparent.
        """
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure

        left, right, low, high = _window(self.grid)
        size = width, max(1.5, width * (high - low) / (right - left))
        figure: Any = Figure(figsize=size, dpi=110, facecolor=paper)
        axes = figure.add_axes((0.06, 0.07, 0.93, 0.92))
        self._draw(axes)
        axes.set(xlim=(left, right), ylim=(low, high), aspect="equal")
        axes.tick_params(labelsize=7, color=_INK, labelcolor=_INK)
        axes.spines[:].set_color(_INK)
        file = io.BytesIO()
        FigureCanvasAgg(figure).print_png(file)
        return file.getvalue()

    def _draw(self, axes: Any) -> None:
        x, y, _ = self.grid.origin
        (rows, columns), cell = self.grid.cells.shape, self.grid.resolution
        shades = np.where(self.grid.cells < 0, 0.8, 1.0 - self.grid.cells.clip(0) / 100)
        extent = (x, x + columns * cell, y, y + rows * cell)
        axes.imshow(shades, cmap="gray", vmin=0, vmax=1, origin="lower", extent=extent, interpolation="nearest")
        if self.outline is not None:
            axes.plot(*self.outline[::2].T, ".", color="#dc2626", markersize=0.6, label=gettext("true walls"))
        for name, track in self.tour.tracks.items() if self.tour else ():
            if np.isfinite(track).any():
                axes.plot(*track[:, :2].T, color=_COLOURS[name], linewidth=1.2, label=name)
        if axes.get_legend_handles_labels()[0]:
            axes.legend(fontsize=7, loc="lower right", markerscale=8)


def _window(grid: GridMap) -> tuple[float, float, float, float]:
    """Return the bounds of the known part with a margin of half a metre: left, right, low, high [m]."""
    rows, columns = np.nonzero(grid.cells >= 0)
    if not len(rows):
        rows, columns = np.array([0, grid.cells.shape[0]]), np.array([0, grid.cells.shape[1]])
    (x, y, _), cell = grid.origin, grid.resolution
    (left, right), (low, high) = ((at.min() * cell - 0.5, at.max() * cell + 0.5) for at in (columns, rows))
    return x + left, x + right, y + low, y + high


def true_outline(robot: str = "", height: float = SCAN_HEIGHT) -> np.ndarray:
    """Return points (n, 2) of all true walls at a height [m], in the map frame: the start pose of the simulated robot."""
    from coursekit.nav.map_compare import outline_points

    name, gazebo = robot_name(robot), simulator()
    gazebo.advance()
    scene = gazebo.simulation.scene(height)
    points = np.concatenate([outline_points(cut.edges, cut.circles) for cut in (scene.fixed, scene.moving())])
    here = gazebo.simulation.pose_of(name)
    off = np.hypot(points[:, 0] - here.x, points[:, 1] - here.y)
    outline: np.ndarray = (
        gazebo.simulation.start_of(name).inverse().transform(points[off > _reach(gazebo.simulation.robots[name])])
    )
    return outline


def _reach(robot: Any) -> float:
    """Return the radius of a circle about the robot's centre that contains the whole robot [m]."""
    corners = [part.corners() for part in robot.model.parts]
    return float(np.hypot(*np.concatenate(corners).T).max()) + 0.02 if corners else 0.0


def map_view(source: str | Path = "/map", *, truth: bool = False, tour: Tour | None = None, robot: str = "") -> MapView:
    """Show a map as a picture, from a topic or a .yaml file.

    `truth` overlays the walls of the simulated world and reports how well they agree; `tour` draws the tracks
    recorded by `drive_along`. LookupError: there is no such topic; TimeoutError: no map arrived; MapError: the file
    is no map.

    >>> %ros2 launch coursekit_robots simulation.launch.py &
    [simulation.launch.py: running]
    >>> %ros2 launch slam_toolbox online_async_launch.py &
    [online_async_launch.py: running]
    >>> wait(3, until="/map")
    >>> map_view("/map")
    map of 128 x 128 cells of 0.05 m: ... walls, ... free, ... unknown
    """
    name = str(source)
    grid = load_map(name) if name.endswith((".yaml", ".yml")) else _heard(name)
    return MapView(grid, true_outline(robot) if truth else None, tour)


def _heard(topic: str) -> GridMap:
    from coursekit.nodes.nav2.map_message import from_message

    hidden = HiddenNode("map_view")
    came, kept = hidden.session.clock.new_event(), []

    def keep(msg: Any) -> None:
        kept.append(msg)
        came.set()

    try:
        listen(hidden, topic, keep)
        if not came.wait(WAIT_SECONDS):
            raise TimeoutError(f"No map came on {topic} within {WAIT_SECONDS:g} s. Is there a scan, and a frame for it?")
        return from_message(kept[-1])
    finally:
        hidden.close()
