"""Numbers over time: live curves with a time line to go back over, or those of a bag."""

from __future__ import annotations

import io
import math
from functools import partial
from pathlib import Path
from typing import Any

from coursekit.cli.ask import full_name
from coursekit.nodes.rqt.curves import Curves, topic_of

from .bundle import with_picture
from .errors import BadArgument, NotThere
from .messages import known_type, listen
from .panel import Panel, static

SECONDS = 20.0
"""The part of the time line that is shown at first [s]."""


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
        """How many points of each curve the browser has."""
        self._began = self.session.clock.steady()
        self._live = bag is None
        try:
            self._hear_all() if bag is None else self._read(bag)
        except (LookupError, BadArgument):
            self.close()
            raise

    # -- where numbers come from

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
            kinds = {one.name: one.type for one in reader.topics()}
            topics = {path: topic_of(path, kinds) for path in self._curves.wanted}
            for path in (path for path, topic in topics.items() if not topic):
                raise NotThere(f"The bag '{bag}' has no topic that {path} begins with. It has: {', '.join(sorted(kinds))}")
            reader.rewind(topics=sorted(set(topics.values())))
            first: int | None = None
            while (message := reader.take()) is not None:
                first = message.stamp if first is None else first
                found = deserialize_message(message.data, get_message(kinds[message.topic]))
                for path in (path for path, topic in topics.items() if topic == message.topic):
                    self._curves.take(path, message.topic, found, (message.stamp - first) * 1e-9)
            reader.close()
        except BagError as error:
            raise BadArgument(f"The bag '{bag}' cannot be plotted: {error}") from None

    # -- what is shown

    def values(self, path: str) -> tuple[list[float], list[float]]:
        """The times [s] and the values of a curve, for computing with them; LookupError lists the names that there are."""
        found = self._curves.curves.get(path if path.startswith("/") else f"/{path}")
        if found is None:
            known = ", ".join(sorted(self._curves.curves)) or "none"
            raise NotThere(f"There is no curve '{path}' (yet). There are: {known}.")
        return list(found.times), list(found.values)

    def shown(self) -> dict[str, Any]:
        """The points that the browser does not have."""
        curves = sorted(self._curves.curves.items())
        news = {name: [_plain(*one) for one in curve.newer(self._sent.get(name, 0))] for name, curve in curves}
        self._sent = {name: curve.total for name, curve in self._curves.curves.items()}
        now = (self.session.clock.steady() - self._began) * 1e-9 if self._live else self._curves.span()[1]
        return {"news": news, "seconds": self.seconds, "live": self._live, "now": now}

    def known_since(self) -> int | None:
        """When its first value came [ns]."""
        return self._began + round(self._curves.span()[0] * 1e9) if self._live and self._curves.curves else None

    def look_back(self) -> None:
        """The cursor has moved: have the page show that time."""
        if self._live and self._seen:
            time = self.cursor.time
            self.tell(type="look", at=None if time is None else (time - self._began) * 1e-9)

    def leave(self) -> None:
        """Without its time line nothing might lead the others back to what happens."""
        if self._live:
            self.cursor.go(None)

    def on_go(self, message: dict[str, Any]) -> None:
        """The plot's own time line was moved: what other panels showed then is shown, too."""
        at = message.get("at")
        if self._live:
            good = isinstance(at, int | float) and math.isfinite(at)
            self.cursor.go(self._began + round(float(at) * 1e9) if good else None)  # type: ignore[arg-type]

    def _hear(self, widget: Any, message: dict[str, Any], buffers: Any) -> None:
        if message.get("type") == "ready":
            self._sent = {}  # a page that is loaded anew has none
        super()._hear(widget, message, buffers)

    def text(self) -> str:
        """A line for each curve: how many values, their range, the last."""
        if not self._curves.curves:
            return f"plot {' '.join(self._curves.wanted)}: no numbers yet"
        return "\n".join(_line(name, list(curve.values)) for name, curve in sorted(self._curves.curves.items()))

    def png(self, start: float | None = None, end: float | None = None) -> bytes:
        """A picture of the time line from `start` to `end` [s]: of the last `seconds`, where these are not said."""
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
    low, high, last = (one + 0.0 for one in (min(values), max(values), values[-1]))  # -0.0 is 0
    return f"{name}: {len(values)} values, {low:.3g} to {high:.3g}, last {last:.3g}"


def _plain(time: float, value: float) -> tuple[float, float | None]:
    """As JSON has it: it knows no infinity, which lasers measure where there is nothing."""
    return round(time, 4), value if math.isfinite(value) else None


def _topic_to_wait_for(path: str) -> str:
    """The topic of a path whose topic does not exist yet: all before the first dot, or before its last part."""
    head, dot, _ = path.partition(".")
    return head if dot else path.rpartition("/")[0] or path


def plot(*paths: str, seconds: float = SECONDS, bag: str | Path | None = None) -> PlotPanel:
    """Numbers of messages over time: `plot("/odom.twist.twist.linear.x", "/cmd_vel.linear.x:angular.z")`.

    A path is a topic and a field of its messages, with dots or slashes; of a topic alone all numbers at the top are drawn.
    The last `seconds` are shown; the time line below goes back over the last five minutes. With `bag` the curves are those
    of a recording. Raises LookupError when there is no such topic.

    In ROS 2: `ros2 run rqt_plot rqt_plot /odom/twist/twist/linear/x`, or PlotJuggler.
    """
    return PlotPanel(paths, seconds, bag)


__all__ = ["PlotPanel", "plot"]
