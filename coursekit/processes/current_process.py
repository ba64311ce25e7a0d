"""Whose code is running: the process of the calling code, kept in a context variable."""

from __future__ import annotations

import contextvars
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .process import Process

owner: contextvars.ContextVar[Process | None] = contextvars.ContextVar("coursekit_process", default=None)


def current_process() -> Process | None:
    """The process in which the calling code runs; None in the interpreter's own code."""
    return owner.get()
