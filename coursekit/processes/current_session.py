"""The present session of the interpreter, below the session itself: streams and threads ask for it all the time."""

from __future__ import annotations

from typing import TYPE_CHECKING

from coursekit.core.virtual_clock import is_virtual_thread

from .current_process import current_process

if TYPE_CHECKING:
    from .session import Session

session: Session | None = None
"""The one that is in use; `coursekit.processes.session` sets it."""


def virtual_session_here() -> Session | None:
    """The session whose virtual clock runs the calling execution context; None for code that the clock does not run."""
    process = current_process()
    here = process.session if process is not None else session
    if here is None or not is_virtual_thread(here.clock):
        return None
    return here if process is not None or not here.embedded or here.in_cell else None


__all__ = ["virtual_session_here"]
