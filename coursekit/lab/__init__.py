"""The lab: what notebooks use. `from coursekit.lab import *` starts the session of the kernel."""

from coursekit.grade.checking import check, hint
from coursekit.grade.progress import progress

from .kernel import reset, start
from .magics import edit, terminal, terminals, wait, workspace
from .pad import pad
from .turtle import turtlesim_window

__all__ = [
    "check",
    "edit",
    "hint",
    "pad",
    "progress",
    "reset",
    "terminal",
    "terminals",
    "turtlesim_window",
    "wait",
    "workspace",
]

start()
