"""The windows of rviz2 nodes: they appear in the notebook by themselves, below the cell that started them."""

from __future__ import annotations

from typing import Any

from coursekit.nodes.rviz import windows
from coursekit.nodes.rviz.config import Config
from coursekit.nodes.rviz.windows import RvizWindow
from coursekit.processes.session import current

from .node_windows import NodeWindows


def _make(window: RvizWindow) -> Any:
    from .viewer import Viewer

    return Viewer(window.config)


_windows = NodeWindows(_make)


def newest() -> Config | None:
    """What the newest rviz2 that runs shows; None when none runs."""
    running = windows.running(current())
    return running[-1].config if running else None


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


__all__ = ["newest", "show_rviz_windows"]
