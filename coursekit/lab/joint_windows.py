"""Windows of joint_state_publisher_gui nodes: sliders below the cell that started the node, until a cell shows them."""

from __future__ import annotations

from coursekit.nodes.robots.boards import boards

from .joint_panel import JointPanel, shown
from .node_windows import NodeWindows

_windows = NodeWindows(boards, lambda board: JointPanel(board.full_name))


def show_joint_windows() -> None:
    """Show the windows of joint_state_publisher_gui nodes in this notebook."""
    _windows.watch()
    if _windows.hide not in shown:
        shown.append(_windows.hide)


__all__ = ["show_joint_windows"]
