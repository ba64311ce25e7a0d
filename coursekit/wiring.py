"""The functions that upper rooms lend to those below: the one place that names them all, as 'package.module:function'.

A lower room imports nothing from above. Where it needs a hand (a program that a session carries out itself, windows for
OpenCV), it looks here for who lends it and loads that when it is used. So a new command or hook is one line in this file.
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
"""Programs that a session carries out itself: the function takes the words of a command and returns its exit code."""

JOIN = "coursekit.cli.attach:attach_script"
"""The function that has the running session carry out a Python program; None when no session runs."""

SERVE = "coursekit.cli.session_server:serve"
"""The function that lets commands of a domain's terminals into a session; None where another session has the domain."""

HOLDER = "coursekit.cli.attach:holder"
"""The function that tells which notebook or test has a domain's terminals: '' for none of them, None for nobody."""

MEET = "coursekit.cli.neighbours:meet"
"""The function that has the interpreter's own nodes meet those of other programs of the same user and domain."""

NETWORK = "coursekit.net.joining:join_as_the_environment_says"
"""The function that has a session join the network that COURSEKIT_NETWORK names, and says whether it is joined."""

IMPORT_HOOKS = {
    "cv2": "coursekit.view.highgui",
    "matplotlib.pyplot": "coursekit.view.plots",
    "multiprocessing.connection": "coursekit.processes.worker_processes",
}
"""Imported module: the module whose `install()` makes it work in a session."""

LAB = "coursekit.lab"
"""The module whose public names and magics a kernel of the course has before its first cell."""

COMPILED_HOST = "nodes/compiled/host.py"
"""The program that runs a compiled one, below the underlay."""


def load(place: str) -> Any:
    """The object at 'package.module:name', or the module at 'package.module'."""
    module, _, name = place.partition(":")
    found = importlib.import_module(module)
    return getattr(found, name) if name else found


def command(name: str) -> Callable[..., int] | None:
    """The function that carries out the program `name` inside of a session; None for other programs.

    >>> command("ls") is None
    True
    """
    found: Callable[..., int] | None = load(COMMANDS[name]) if name in COMMANDS else None
    return found
