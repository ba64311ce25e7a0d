"""The windows of joint_state_publisher_gui nodes: sliders below the cell that started them, until a cell shows them."""

from __future__ import annotations

from coursekit.nodes.robots.boards import Board, boards

from .joint_panel import JointPanel, shown
from .node_windows import NodeWindows

_windows = NodeWindows(lambda board: JointPanel(board.full_name))


def show_joint_windows() -> None:
    """Have joint_state_publisher_gui nodes show their windows in this notebook."""
    boards.unwatch(_hear)
    boards.watch(_hear)
    if _windows.hide not in shown:
        shown.append(_windows.hide)


def _hear(board: Board) -> None:
    session = board.session
    if not session.embedded or session.clock.virtual:
        return
    if board.running:
        _windows.show(board)
    else:
        session.spawn(_windows.forget, board)


__all__ = ["show_joint_windows"]
