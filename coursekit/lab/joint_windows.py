"""The windows of joint_state_publisher_gui nodes: sliders below the cell that started them, until a cell shows them."""

from __future__ import annotations

from typing import Any

from coursekit.nodes.robots import boards
from coursekit.nodes.robots.boards import Board

_shown: dict[int, Any] = {}
"""The panels by their board; None where there is none yet, or a cell has taken over"""


def show_joint_windows() -> None:
    """Have joint_state_publisher_gui nodes show their windows in this notebook."""
    boards.unwatch(_hear)
    boards.watch(_hear)


def take_over(board: Board) -> None:
    """A cell shows these sliders: their window goes."""
    panel = _shown.get(id(board))
    _shown[id(board)] = None
    if panel is not None:
        panel.close()


def _hear(board: Board) -> None:
    session = board.session
    if not session.embedded or session.clock.virtual:
        return
    if board.running and id(board) not in _shown:
        _shown[id(board)] = None
        session.spawn(_open, board)
    elif not board.running and id(board) in _shown:
        session.spawn(_close, board)


def _open(board: Board) -> None:
    from IPython.display import display

    from .joint_panel import JointPanel
    from .panel import open_panels

    if board.running and not any(isinstance(one, JointPanel) and one.shows(board) for one in open_panels()):
        made = _shown[id(board)] = JointPanel(board.full_name)
        made.of_cell = False
        display(made)


def _close(board: Board) -> None:
    panel = _shown.pop(id(board), None)
    if panel is not None:
        panel.close()


__all__ = ["show_joint_windows", "take_over"]
