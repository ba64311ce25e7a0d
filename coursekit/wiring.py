"""The functions that upper packages provide to lower ones, as 'package.module:function', all in one place.

A lower package imports nothing from upper ones. If it needs one of their functions (a program that a session runs itself,
windows for OpenCV), it looks the name up here and loads it on use. So a new command or hook is one line in this file.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Any

COMMANDS = {
    "ros2": "coursekit.cli.parser:run",
    "gazebo": "coursekit.cli.gazebo_commands:run_server",
    "gzserver": "coursekit.cli.gazebo_commands:run_server",
    "gzclient": "coursekit.cli.gazebo_commands:run_client",
    "gz": "coursekit.cli.gz_commands:run_inside",
    "ign": "coursekit.cli.gz_commands:run_inside",
    "rviz2": "coursekit.cli.window_commands:rviz2_inside",
    "rqt": "coursekit.cli.window_commands:rqt_inside",
    "rqt_graph": "coursekit.cli.window_commands:graph_inside",
    "rqt_console": "coursekit.cli.window_commands:console_inside",
    "rqt_plot": "coursekit.cli.window_commands:plot_inside",
}
"""Programs that a session runs itself: the function takes the command's arguments and returns its exit code."""

JOIN = "coursekit.cli.session_client:attach_script"
"""The function that runs a Python program in the running session; None when no session runs."""

SERVE = "coursekit.cli.session_server:serve"
"""The function that serves a domain's terminal commands for a session; None if another session has the domain."""

HOLDER = "coursekit.cli.session_client:holder"
"""The function that returns the notebook or test that has a domain's terminals: '' for neither, None if unused."""

MEET = "coursekit.cli.neighbours:meet"
"""The function that connects the interpreter's own nodes with those of the same user's programs in the domain."""

NETWORK = "coursekit.net.joining:join_as_the_environment_says"
"""The function that joins a session to the network in COURSEKIT_NETWORK, and returns whether it is joined."""

IMPORT_HOOKS = {
    "cv2": "coursekit.view.highgui",
    "matplotlib.pyplot": "coursekit.view.plots",
    "multiprocessing.connection": "coursekit.processes.worker_processes",
    "numpy": "coursekit.processes.older_numpy",
    **dict.fromkeys(
        ("scipy", "scipy.integrate", "scipy.linalg", "scipy.signal", "scipy.sparse"), "coursekit.processes.older_scipy"
    ),
}
"""Imported module, and the module whose `install()` patches it for a session."""

LAB = "coursekit.lab"
"""The module whose public names and magics a course kernel has before its first cell."""

COMPILED_HOST = "nodes/compiled/host.py"
"""The program that hosts a compiled one, below the underlay."""


def load(place: str) -> Any:
    """Return the object at 'package.module:name', or the module at 'package.module'."""
    module, _, name = place.partition(":")
    imported = importlib.import_module(module)
    return getattr(imported, name) if name else imported


def command(name: str) -> Callable[..., int] | None:
    """Return the function that runs the program `name` inside a session; None for other programs.

    >>> command("ls") is None
    True
    """
    command: Callable[..., int] | None = load(COMMANDS[name]) if name in COMMANDS else None
    return command
