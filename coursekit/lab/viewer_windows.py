"""The windows of rviz2 nodes: they appear in the notebook by themselves, below the cell that started them."""

from __future__ import annotations

from typing import Any

from coursekit.core.session import current
from coursekit.nodes.rviz import windows
from coursekit.nodes.rviz.config import Config
from coursekit.nodes.rviz.windows import RvizWindow

_shown: dict[int, Any] = {}
"""The viewers by the number of their window"""


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
        session.spawn(_open if window.running else _close, window)
    return True


def _open(window: RvizWindow) -> None:
    from IPython.display import display

    from .viewer import Viewer

    if window.running:
        made = _shown[id(window)] = Viewer(window.config)
        made.of_cell = False
        display(made)


def _close(window: RvizWindow) -> None:
    panel = _shown.pop(id(window), None)
    if panel is not None:
        panel.close()


__all__ = ["newest", "show_rviz_windows"]
