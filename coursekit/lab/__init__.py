"""The lab: the functions for notebooks. `from coursekit.lab import *` starts the kernel's session."""

from coursekit.grade.checking import check, hint
from coursekit.grade.progress import progress
from coursekit.urdf.resources import take_environment_from

from .backup_folders import set_aside
from .compiled import compiled
from .desk import desk
from .frames_panel import frames
from .graph_panel import graph
from .handing_in import evidence, hand_in
from .image_view import image_view
from .joint_panel import joint_sliders
from .joint_windows import show_joint_windows
from .kernel import reset, start
from .log_console import log_console
from .magics import edit, terminal, terminals, workspace, workspace_environment
from .map_view import map_view
from .messages import echo
from .network_panel import network_panel
from .parameter_panel import parameter_panel
from .path_view import path_view
from .plot_panel import plot
from .practice_robot import practice_robot, weak_link
from .publisher_panel import message_publisher
from .rqt_windows import show_rqt_windows
from .service_panel import service_caller
from .teleop_pad import pad
from .timeline import timeline
from .topic_panel import topic_panel
from .tour import drive_along
from .turtle import turtlesim_window
from .viewer import viewer
from .viewer_windows import show_rviz_windows
from .waiting import wait
from .windows import show_new_windows, windows
from .world_windows import show_world_windows, world_view

__all__ = [
    "check",
    "compiled",
    "desk",
    "drive_along",
    "echo",
    "edit",
    "evidence",
    "frames",
    "graph",
    "hand_in",
    "hint",
    "image_view",
    "joint_sliders",
    "log_console",
    "map_view",
    "message_publisher",
    "network_panel",
    "pad",
    "parameter_panel",
    "path_view",
    "plot",
    "practice_robot",
    "progress",
    "reset",
    "service_caller",
    "set_aside",
    "terminal",
    "terminals",
    "timeline",
    "topic_panel",
    "turtlesim_window",
    "viewer",
    "wait",
    "weak_link",
    "windows",
    "workspace",
    "world_view",
]

start()
take_environment_from(workspace_environment)
show_new_windows()
show_rviz_windows()
show_joint_windows()
show_rqt_windows()
show_world_windows()
