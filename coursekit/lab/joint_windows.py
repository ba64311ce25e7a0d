"""The windows of joint_state_publisher_gui nodes: sliders below the cell that started them, until a cell shows them."""

from __future__ import annotations

from typing import Any

from coursekit.nodes.robots import boards
from coursekit.nodes.robots.boards import Board

from .node_windows import NodeWindows


def _make(board: Board) -> Any:
    from .joint_panel import JointPanel

    return JointPanel(board.full_name)


_windows = NodeWindows(_make)


def show_joint_windows() -> None:
    """Have joint_state_publisher_gui nodes show their windows in this notebook."""
    boards.unwatch(_hear)
    boards.watch(_hear)


def take_over(board: Board) -> None:
    """A cell shows these sliders: their window goes."""
    _windows.hide(board)


def _hear(board: Board) -> None:
    session = board.session
    if not session.embedded or session.clock.virtual:
        return
    if board.running:
        _windows.show(board)
    else:
        session.spawn(_windows.forget, board)


__all__ = ["show_joint_windows", "take_over"]
