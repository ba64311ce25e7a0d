"""Programs that a session carries out itself, named here and loaded when they are used.

The rooms above this one hold them, so they stand here by name only.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Sequence
from typing import Any

INSIDE = {
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
"""Command: the function that takes its words and returns its exit code."""

JOIN = "coursekit.cli.attach:attach_script"
"""The function that has the running session carry out a Python program; None when no session runs."""

DOOR = "coursekit.cli.hub:open_door"
"""The function that lets commands of a domain's terminals into a session; None where another session has the domain."""

HOLDER = "coursekit.cli.attach:holder"
"""The function that tells which notebook or test has a domain's terminals: '' for none of them, None for nobody."""

MEET = "coursekit.cli.neighbours:meet"
"""The function that has the interpreter's own nodes meet those of other programs of the same user and domain."""

COMPILED = "nodes/compiled/host.py"
"""The program that runs a compiled one, below the underlay."""


def load(place: str) -> Callable[..., Any]:
    """The function at 'package.module:function'."""
    module, _, function = place.partition(":")
    found: Callable[..., Any] = getattr(importlib.import_module(module), function)
    return found


def inside(command: str) -> Callable[[Sequence[str]], int] | None:
    """What carries out `command` inside of the session; None for other programs.

    >>> inside("ls") is None
    True
    """
    return load(INSIDE[command]) if command in INSIDE else None
