"""The windows of rviz2 nodes: they appear in the notebook by themselves, below the cell that started them."""

from __future__ import annotations

from coursekit.nodes.rviz.windows import windows

from .node_windows import NodeWindows
from .viewer import Viewer

_windows = NodeWindows(windows, lambda window: Viewer(window.config))


def show_rviz_windows() -> None:
    """Have rviz2 nodes show their windows in this notebook."""
    _windows.watch()


__all__ = ["show_rviz_windows"]
