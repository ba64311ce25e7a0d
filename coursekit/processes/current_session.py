"""The interpreter's current session, separate from `session`: streams and threads need it all the time."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

from coursekit.core.virtual_clock import is_virtual_thread

from .current_process import current_process

if TYPE_CHECKING:
    from .session import Session

_OF_THE_KERNEL = ("IPython", "anywidget", "asyncio", "comm", "ipykernel", "ipywidgets", "tornado", "traitlets", "zmq")
_OF_PYTHON = ("concurrent", "coursekit", "queue", "threading")

session: Session | None = None
"""The session in use; `coursekit.processes.session` sets it."""


def virtual_session_here() -> Session | None:
    """Return the session whose virtual clock runs the calling execution context; None for code outside of it."""
    process = current_process()
    here = process.session if process is not None else session
    if here is None or not is_virtual_thread(here.clock):
        return None
    return here if process is not None or not here.embedded or here.in_cell else None


def waiting_session() -> Any:
    """Return the virtual session on whose clock the caller waits; None for the kernel's libraries, which wait for real."""
    session = virtual_session_here()
    if session is None or not session.embedded or current_process() is not None:
        return session
    return None if _caller() in _OF_THE_KERNEL else session


def starting_session() -> Any:
    """Return the virtual session for a new thread's clock; None while IPython waits for a system program."""
    session = virtual_session_here()
    if session is None or not session.embedded or current_process() is not None:
        return session
    return None if _caller() == "IPython" else session


def _caller() -> str:
    """Return the calling library, skipping Python's own and ours."""
    frame: Any = sys._getframe(2)
    while frame is not None:
        top = str(frame.f_globals.get("__name__", "")).partition(".")[0]
        if top not in _OF_PYTHON:
            return top
        frame = frame.f_back
    return ""


__all__ = ["starting_session", "virtual_session_here", "waiting_session"]
