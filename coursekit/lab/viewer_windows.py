"""The windows of rviz2 nodes: they appear automatically below the cell that started the node."""

from __future__ import annotations

from coursekit.nodes.rviz.windows import windows

from .node_windows import NodeWindows
from .viewer import Viewer

_windows = NodeWindows(windows, lambda window: Viewer(window.config))


def show_rviz_windows() -> None:
    """Show the windows of rviz2 nodes in this notebook."""
    _windows.watch()


__all__ = ["show_rviz_windows"]
