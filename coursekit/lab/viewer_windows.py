"""The windows of rviz2 nodes: they appear in the notebook by themselves, below the cell that started them."""

from __future__ import annotations

from coursekit.nodes.rviz.windows import RvizWindow, windows

from .node_windows import NodeWindows
from .viewer import Viewer

_windows = NodeWindows(lambda window: Viewer(window.config))


def show_rviz_windows() -> None:
    """Have rviz2 nodes show their windows in this notebook."""
    windows.unwatch(_hear)
    windows.watch(_hear)


def _hear(window: RvizWindow) -> bool:
    session = window.session
    if not session.embedded:
        return False
    if not session.clock.virtual:
        if window.running:
            _windows.show(window)
        else:
            session.spawn(_windows.forget, window)
    return True


__all__ = ["show_rviz_windows"]
