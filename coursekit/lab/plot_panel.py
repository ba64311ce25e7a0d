"""Numbers over time: live curves with a time line for going back, or the curves of a bag."""

from __future__ import annotations

import io
import math
from functools import partial
from pathlib import Path
from typing import Any

from coursekit.cli.api import full_name
from coursekit.nodes.rqt.curves import Curves, topic_of

from .bundle import with_picture
from .errors import BadArgument, NotThere
from .messages import known_type, listen
from .panel import Panel, static

SECONDS = 20.0
"""The length of the time line shown at first [s]."""


class PlotPanel(Panel):
    """See `plot`."""

    _esm = static("plot.js")
    _css = static("plot.css")

    def __init__(self, wanted: tuple[str, ...], seconds: float, bag: str | Path | None) -> None:
        if not wanted:
            raise BadArgument('Say what to plot: plot("/odom.twist.twist.linear.x"), or of a bag: plot(..., bag="drive")')
        super().__init__("plot" if bag is None else "")
        self.seconds = seconds
        self._curves = Curves(wanted)
        self._sent: dict[str, int] = {}
        """How many points of each curve the browser has received."""
        self._began = self.session.clock.steady()
        self._live = bag is None
        try:
            self._hear_all() if bag is None else self._read(bag)
        except (LookupError, BadArgument):
            self.close()
            raise

    # -- sources of the numbers

    def _hear_all(self) -> None:
        for path in self._curves.wanted:
            topic = topic_of(path, [name for name, _ in self.hidden.graph.topics()]) or _topic_to_wait_for(path)
            known_type(self.hidden.graph, full_name(topic))
            listen(self.hidden, topic, partial(self._take, path, topic))

    def _take(self, path: str, topic: str, message: Any) -> None:
        self._curves.take(path, topic, message, (self.session.clock.steady() - self._began) * 1e-9)
        self.changed()

    def _read(self, bag: str | Path) -> None:
        from rclpy.serialization import deserialize_message
        from rosidl_runtime_py.utilities import get_message

        from coursekit.bag.errors import BagError
        from coursekit.bag.reader import BagReader

        try:
            reader = BagReader(str(bag))
            kinds = {recorded.name: recorded.type for recorded in reader.topics()}
            topics = {path: topic_of(path, kinds) for path in self._curves.wanted}
            for path in (path for path, topic in topics.items() if not topic):
                raise NotThere(f"The bag '{bag}' has no topic that {path} begins with. It has: {', '.join(sorted(kinds))}")
            reader.rewind(topics=sorted(set(topics.values())))
            first: int | None = None
            while (message := reader.take()) is not None:
                first = message.stamp if first is None else first
                decoded = deserialize_message(message.data, get_message(kinds[message.topic]))
                for path in (path for path, topic in topics.items() if topic == message.topic):
                    self._curves.take(path, message.topic, decoded, (message.stamp - first) * 1e-9)
            reader.close()
        except BagError as error:
            raise BadArgument(f"The bag '{bag}' cannot be plotted: {error}") from None

    # -- what is shown

    def values(self, path: str) -> tuple[list[float], list[float]]:
        """Return the times [s] and the values of a curve; LookupError lists the existing names."""
        curve = self._curves.curves.get(path if path.startswith("/") else f"/{path}")
        if curve is None:
            known = ", ".join(sorted(self._curves.curves)) or "none"
            raise NotThere(f"There is no curve '{path}' (yet). There are: {known}.")
        return list(curve.times), list(curve.values)

    def shown(self) -> dict[str, Any]:
        """Return the points that the browser lacks."""
        curves = sorted(self._curves.curves.items())
        news = {name: [_plain(*point) for point in curve.newer(self._sent.get(name, 0))] for name, curve in curves}
        self._sent = {name: curve.total for name, curve in self._curves.curves.items()}
        now = (self.session.clock.steady() - self._began) * 1e-9 if self._live else self._curves.span()[1]
        return {"news": news, "seconds": self.seconds, "live": self._live, "now": now}

    def known_since(self) -> int | None:
        """Return when the first value arrived [ns]."""
        return self._began + round(self._curves.span()[0] * 1e9) if self._live and self._curves.curves else None

    def look_back(self) -> None:
        """Handle a moved cursor: show that time on the page."""
        if self._live and self._seen:
            time = self.cursor.time
            self.tell(type="look", at=None if time is None else (time - self._began) * 1e-9)

    def leave(self) -> None:
        """Go back to live: without its time line, other panels might have no control for this."""
        if self._live:
            self.cursor.go(None)

    def on_go(self, message: dict[str, Any]) -> None:
        """Handle the plot's own time line: other panels go to the same time."""
        at = message.get("at")
        if self._live:
            good = isinstance(at, int | float) and math.isfinite(at)
            self.cursor.go(self._began + round(float(at) * 1e9) if good else None)  # type: ignore[arg-type]

    def _hear(self, widget: object, message: dict[str, Any], buffers: object) -> None:
        if message.get("type") == "ready":
            self._sent = {}  # a reloaded page has no points
        super()._hear(widget, message, buffers)

    def text(self) -> str:
        """Return a line for each curve: the number of values, their range, the last value."""
        if not self._curves.curves:
            return f"plot {' '.join(self._curves.wanted)}: no numbers yet"
        return "\n".join(_line(name, list(curve.values)) for name, curve in sorted(self._curves.curves.items()))

    def png(self, start: float | None = None, end: float | None = None) -> bytes:
        """Return a picture of the time line from `start` to `end` [s]; by default of the last `seconds`."""
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure

        first, last = self._curves.span()
        end = last if end is None else end
        start = (max(first, end - self.seconds) if self._live else first) if start is None else start
        figure: Any = Figure(figsize=(7.2, 3.2), dpi=100, layout="constrained")
        axes = figure.subplots()
        for name, curve in sorted(self._curves.curves.items()):
            axes.plot(*curve.between(start, end), label=name)
        axes.set(xlim=(start, max(end, start + 1e-3)), xlabel="seconds")
        axes.grid(alpha=0.3)
        if self._curves.curves:
            figure.legend(loc="outside upper left", ncols=2, frameon=False)
        file = io.BytesIO()
        FigureCanvasAgg(figure).print_png(file)
        return file.getvalue()


    def _repr_mimebundle_(self, **options: Any) -> Any:
        bundle = super()._repr_mimebundle_(**options)
        return with_picture(bundle, self.png) if self._curves.curves else bundle


def _line(name: str, values: list[float]) -> str:
    low, high, last = (value + 0.0 for value in (min(values), max(values), values[-1]))  # -0.0 is 0
    return f"{name}: {len(values)} values, {low:.3g} to {high:.3g}, last {last:.3g}"


def _plain(time: float, value: float) -> tuple[float, float | None]:
    """Convert a point to JSON numbers: infinity, a laser's reading without an echo, becomes None."""
    return round(time, 4), value if math.isfinite(value) else None


def _topic_to_wait_for(path: str) -> str:
    """Return the topic of a path whose topic does not exist yet: all before the first dot, or before its last part."""
    head, dot, _ = path.partition(".")
    return head if dot else path.rpartition("/")[0] or path


def plot(*paths: str, seconds: float = SECONDS, bag: str | Path | None = None) -> PlotPanel:
    """Plot numbers in messages over time: `plot("/odom.twist.twist.linear.x", "/cmd_vel.linear.x:angular.z")`.

    A path is a topic and a field of its messages, with dots or slashes; a topic alone draws all of its top-level
    numbers. The last `seconds` are shown; the time line below goes back over the last five minutes. With `bag` the
    curves are those of a recording. Raises LookupError when there is no such topic.

    >>> %ros2 run turtlesim turtlesim_node &
    [turtlesim_node: running]
    >>> curves = plot("/turtle1/pose.x", "/turtle1/pose.theta")
    >>> wait(2)
    >>> curves
    /turtle1/pose.theta: 125 values, 0 to 0, last 0
    /turtle1/pose.x: 125 values, 5.54 to 5.54, last 5.54

    In ROS 2: `ros2 run rqt_plot rqt_plot /odom/twist/twist/linear/x`, or PlotJuggler.
    """
    return PlotPanel(paths, seconds, bag)


__all__ = ["PlotPanel", "plot"]
