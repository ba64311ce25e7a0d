"""`ros2 run rqt_plot rqt_plot /turtle1/pose/x:y`: numbers of topics over the last seconds, in a window."""

from __future__ import annotations

import sys
from collections import deque
from collections.abc import Iterator, Sequence
from typing import Any

import cv2
import numpy as np
import rclpy
from rclpy.qos import qos_profile_sensor_data
from rclpy.utilities import remove_ros_args

from coursekit.interfaces import load
from coursekit.nodes.running import spin_to_the_end

from .rqt import Rqt, name_of_process

SECONDS = 20.0
"""What is shown of the past."""
KEPT = 4000
"""Points of a curve."""


def paths(words: Sequence[str]) -> list[str]:
    """What is to be plotted, one path each.

    >>> paths(["/turtle1/pose/x:y", "/speed/data"])
    ['/turtle1/pose/x', '/turtle1/pose/y', '/speed/data']
    """
    found = []
    for word in (one for one in words if one.strip(";")):
        first, *others = word.strip(";").split(":")
        before = first.rpartition("/")[0]
        found += [first, *(f"{before}/{one}" for one in others)]
    return found


def numbers(value: Any, name: str) -> Iterator[tuple[str, float]]:
    """The numbers of a message's field; of a message all that it has at the top."""
    if isinstance(value, (bool, int, float)):
        yield name, float(value)
    elif hasattr(value, "get_fields_and_field_types"):
        for field in value.get_fields_and_field_types():
            inner = getattr(value, field)
            if isinstance(inner, (bool, int, float)):
                yield f"{name}/{field}", float(inner)


def part(message: Any, fields: str) -> Any:
    """A part of a message, such as `pose/x` or `ranges[3]`; None when it has none such."""
    found = message
    for word in filter(None, fields.split("/")):
        name, _, index = word.rstrip("]").partition("[")
        found = getattr(found, name, None)
        if index:
            found = found[int(index)] if found is not None and index.isdigit() and int(index) < len(found) else None
    return found


class Plot(Rqt):
    """Subscribes to the topics of its paths as soon as they are there, and draws twice a second."""

    def __init__(self, wanted: Sequence[str]) -> None:
        self.title = name_of_process().replace("rqt_gui_py_node", "rqt_plot")
        super().__init__("rqt_plot", self.title)
        self.curves: dict[str, deque[tuple[float, float]]] = {}
        """By path: seconds and values."""
        self._waiting = [one if one.startswith("/") else f"/{one}" for one in wanted]
        self._began = self.get_clock().now()
        self.create_timer(0.5, self._look)

    def _look(self) -> None:
        known = {name: types[0] for name, types in self.get_topic_names_and_types()}
        for path in list(self._waiting):
            fitting = [name for name in known if path == name or path.startswith(f"{name}/")]
            if fitting:
                self._waiting.remove(path)
                self._listen(max(fitting, key=len), path, known)
        self._draw()

    def _listen(self, topic: str, path: str, known: dict[str, str]) -> None:
        fields = path[len(topic) :].strip("/")

        def hear(message: Any) -> None:
            now = (self.get_clock().now() - self._began).nanoseconds * 1e-9
            for name, number in numbers(part(message, fields), path):
                self.curves.setdefault(name, deque(maxlen=KEPT)).append((now, number))

        self.create_subscription(load(known[topic]), topic, hear, qos_profile_sensor_data)

    def _draw(self) -> None:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure

        figure: Any = Figure(figsize=(7.2, 3.6), dpi=100, layout="constrained")
        axes = figure.subplots()
        for name, points in sorted(self.curves.items()):
            axes.plot(*zip(*points, strict=True), label=name)
        now = (self.get_clock().now() - self._began).nanoseconds * 1e-9
        axes.set(xlim=(max(0.0, now - SECONDS), max(now, 1.0)), xlabel="seconds")
        axes.grid(alpha=0.3)
        if self.curves:
            axes.legend(loc="upper left")
        canvas: Any = FigureCanvasAgg(figure)
        canvas.draw()
        cv2.imshow(self.title, np.ascontiguousarray(np.asarray(canvas.buffer_rgba())[..., 2::-1]))

    def destroy_node(self) -> None:
        """Close the window."""
        if cv2.getWindowProperty(self.title, cv2.WND_PROP_VISIBLE) > 0:
            cv2.destroyWindow(self.title)
        super().destroy_node()


def main() -> int:
    """Plot until Ctrl-C."""
    wanted = paths(remove_ros_args(sys.argv)[1:])
    if not wanted:
        print("Say what to plot, as in: ros2 run rqt_plot rqt_plot /turtle1/pose/x:y", file=sys.stderr)
        return 1
    rclpy.init()
    return spin_to_the_end(Plot(wanted))
