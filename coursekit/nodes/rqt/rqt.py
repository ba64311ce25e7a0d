"""`ros2 run rqt_graph rqt_graph`, and others: a panel in the notebook, if there is one; else the commands to use."""

from __future__ import annotations

import os
import sys
from functools import partial

import rclpy
from rclpy.node import Node

from coursekit.nodes.running import spin_to_the_end
from coursekit.processes.process import current_process
from coursekit.processes.session import current

from .windows import RqtWindow, windows

INSTEAD = {
    "rqt_graph": "`ros2 node list`, and `ros2 node info NODE`",
    "rqt_console": "`ros2 topic echo /rosout`, or the terminals that the nodes run in",
    "rqt_gui": "`ros2 service call`, `ros2 topic echo` and `ros2 param set`",
}
"""The commands that replace a window in a terminal, by window."""


def name_of_process() -> str:
    """The name of rqt's node, which contains the process ID."""
    process = current_process()
    return f"rqt_gui_py_node_{process.pid if process is not None else os.getpid()}"


class Rqt(Node):
    """A window's node."""

    def __init__(self, kind: str, picture: str = "") -> None:
        super().__init__(name_of_process())
        self.window = RqtWindow(kind, current(), picture)
        self.drawn = windows.tell(self.window)

    def destroy_node(self) -> None:
        """Close the window."""
        self.window.running = False
        windows.tell(self.window)
        super().destroy_node()


def main(kind: str) -> int:
    """Show the window until Ctrl-C; return 1 if no notebook shows it."""
    rclpy.init()
    node = Rqt(kind)
    if node.drawn:
        return spin_to_the_end(node)
    print(f"No notebook shows this window. Here: {INSTEAD[kind]}.", file=sys.stderr)
    node.destroy_node()
    rclpy.try_shutdown()
    return 1


graph, console, gui = partial(main, "rqt_graph"), partial(main, "rqt_console"), partial(main, "rqt_gui")
