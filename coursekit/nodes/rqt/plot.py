"""`ros2 run rqt_plot rqt_plot /turtle1/pose/x:y`: values of topics over the last seconds, in a window."""

from __future__ import annotations

import sys
from typing import Any

import cv2
import numpy as np
import rclpy
from rclpy.qos import qos_profile_sensor_data
from rclpy.utilities import remove_ros_args

from coursekit.interfaces import load
from coursekit.nodes.running import spin_to_the_end

from .curves import Curves, topic_of
from .rqt import Rqt, name_of_process

SECONDS = 20.0
"""The length of the time window that is shown [s]."""


class Plot(Rqt):
    """Subscribes to the topics of its paths as soon as they appear, and draws twice a second."""

    def __init__(self, curves: Curves) -> None:
        self.title = name_of_process().replace("rqt_gui_py_node", "rqt_plot")
        super().__init__("rqt_plot", self.title)
        self.show()
        self.curves = curves
        self._waiting = list(curves.wanted)
        self._began = self.get_clock().now()
        self.create_timer(0.5, self._look)

    def _look(self) -> None:
        known = {name: types[0] for name, types in self.get_topic_names_and_types()}
        for path in list(self._waiting):
            if topic := topic_of(path, known):
                self._waiting.remove(path)
                self._listen(topic, path, known)
        self._draw()

    def _listen(self, topic: str, path: str, known: dict[str, str]) -> None:
        def hear(message: Any) -> None:
            self.curves.take(path, topic, message, (self.get_clock().now() - self._began).nanoseconds * 1e-9)

        self.create_subscription(load(known[topic]), topic, hear, qos_profile_sensor_data)

    def _draw(self) -> None:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure

        figure: Any = Figure(figsize=(7.2, 3.6), dpi=100, layout="constrained")
        axes = figure.subplots()
        for name, curve in sorted(self.curves.curves.items()):
            axes.plot(list(curve.times), list(curve.values), label=name)
        now = (self.get_clock().now() - self._began).nanoseconds * 1e-9
        axes.set(xlim=(max(0.0, now - SECONDS), max(now, 1.0)), xlabel="seconds")
        axes.grid(alpha=0.3)
        if self.curves.curves:
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
    curves = Curves(remove_ros_args(sys.argv)[1:])
    if not curves.wanted:
        print("Say what to plot, as in: ros2 run rqt_plot rqt_plot /turtle1/pose/x:y", file=sys.stderr)
        return 1
    rclpy.init()
    return spin_to_the_end(Plot(curves))
