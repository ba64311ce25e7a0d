"""The windows of `gzclient`: the world's view appears in the notebook by itself, below the cell that started it."""

from __future__ import annotations

from coursekit.nodes.gazebo.gzclient import WorldWindow, windows

from .node_windows import NodeWindows
from .world_view import WorldView

_windows = NodeWindows(lambda _window: WorldView())


def show_world_windows() -> None:
    """Have gzclient show its window in this notebook."""
    windows.unwatch(_hear)
    windows.watch(_hear)


def _hear(window: WorldWindow) -> bool:
    session = window.session
    if not session.embedded:
        return False
    if not session.clock.virtual:
        if window.running:
            _windows.show(window)
        else:
            session.spawn(_windows.forget, window)
    return True


__all__ = ["show_world_windows"]
