"""The windows of rqt: their panels appear in the notebook automatically, as those of rviz2 do."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import ipywidgets

from coursekit.nodes.rqt.windows import RqtWindow, windows
from coursekit.view.desk import Window, desk, unwatch, watch

from .frames_panel import FramesPanel
from .graph_panel import GraphPanel
from .log_console import LogConsole
from .node_windows import NodeWindows
from .publisher_panel import MessagePublisher
from .reconfigure import Reconfigure
from .service_panel import ServiceCaller
from .teleop_pad import Pad
from .topic_panel import TopicPanel
from .windows import WindowPicture

_TABS: dict[str, Callable[[], Any]] = {
    "Service Caller": ServiceCaller,
    "Topic Monitor": TopicPanel,
    "Message Publisher": MessagePublisher,
    "Dynamic Reconfigure": Reconfigure,
    "Console": LogConsole,
    "Node Graph": lambda: GraphPanel("active"),
    "TF Tree": FramesPanel,
}
"""The plugins of `rqt`, under the names in its menu."""


class RqtTabs(ipywidgets.Tab):
    """The window of `rqt` itself: its plugins in tabs."""

    def __init__(self) -> None:
        panels = [make() for make in _TABS.values()]
        for panel in panels:
            panel.of_cell = False
        super().__init__(panels, titles=list(_TABS))

    def close(self) -> None:
        """Close all plugins."""
        for panel in self.children:
            panel.close()
        super().close()


class PlotPicture(WindowPicture):
    """The curves drawn by `rqt_plot`."""

    def __init__(self, name: str) -> None:
        super().__init__(desk(), desk().window(name))
        watch(self._newer)

    def _newer(self, window: Window) -> None:
        if window is self.window:
            self.news()

    def close(self) -> None:
        """Stop watching the window."""
        unwatch(self._newer)
        super().close()


_KINDS: dict[str, Callable[[RqtWindow], Any]] = {
    "rqt_graph": lambda _: GraphPanel("active"),
    "rqt_console": lambda _: LogConsole(),
    "rqt_plot": lambda window: PlotPicture(window.picture),
    "rqt_gui": lambda _: RqtTabs(),
    "rqt_publisher": lambda _: MessagePublisher(),
    "rqt_reconfigure": lambda _: Reconfigure(),
    "rqt_robot_steering": lambda window: Pad(window.topic, *window.speeds, holonomic=False),
    "rqt_service_caller": lambda _: ServiceCaller(),
    "rqt_tf_tree": lambda _: FramesPanel(),
    "rqt_topic": lambda _: TopicPanel(),
}
_windows = NodeWindows(windows, lambda window: _KINDS[window.kind](window))


def show_rqt_windows() -> None:
    """Show rqt's windows in this notebook."""
    _windows.watch()


__all__ = ["RqtTabs", "show_rqt_windows"]
