"""`ros2 run rqt_graph rqt_graph`, and others: a panel in the notebook, if there is one; else the commands to use."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
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
    "rqt_publisher": "`ros2 topic pub TOPIC TYPE VALUES`",
    "rqt_reconfigure": "`ros2 param list`, `ros2 param set NODE PARAMETER VALUE`, and `ros2 param describe`",
    "rqt_robot_steering": "`ros2 run teleop_twist_keyboard teleop_twist_keyboard`",
    "rqt_service_caller": "`ros2 service list -t`, and `ros2 service call SERVICE TYPE VALUES`",
    "rqt_tf_tree": "`ros2 run tf2_tools view_frames`",
    "rqt_topic": "`ros2 topic list -t`, `ros2 topic echo TOPIC` and `ros2 topic hz TOPIC`",
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

    def show(self) -> bool:
        """Open the window; return whether a notebook shows it."""
        return windows.tell(self.window)

    def destroy_node(self) -> None:
        """Close the window."""
        self.window.running = False
        windows.tell(self.window)
        super().destroy_node()


class RobotSteering(Rqt):
    """The window that drives a robot, with the parameters of rqt_robot_steering."""

    def __init__(self) -> None:
        super().__init__("rqt_robot_steering")
        self.window.topic = self.declare_parameter("default_topic", "/cmd_vel").value
        fastest = self.declare_parameter("default_vx_max", 1.0), self.declare_parameter("default_vw_max", 3.0)
        self.window.speeds = (fastest[0].value, fastest[1].value)


def main(make: Callable[[], Rqt]) -> int:
    """Show a window until Ctrl-C; return 1 if no notebook shows it."""
    rclpy.init()
    node = make()
    if node.show():
        return spin_to_the_end(node)
    print(f"No notebook shows this window. Here: {INSTEAD[node.window.kind]}.", file=sys.stderr)
    node.destroy_node()
    rclpy.try_shutdown()
    return 1


graph, console, gui, publisher, reconfigure, service_caller, tf_tree, topic = (
    partial(main, partial(Rqt, f"rqt_{kind}"))
    for kind in ("graph", "console", "gui", "publisher", "reconfigure", "service_caller", "tf_tree", "topic")
)
robot_steering = partial(main, RobotSteering)
