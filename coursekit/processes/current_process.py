"""The process of the running code, stored in a context variable."""

from __future__ import annotations

import contextvars
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .process import Process

owner: contextvars.ContextVar[Process | None] = contextvars.ContextVar("coursekit_process", default=None)


def current_process() -> Process | None:
    """Return the process of the calling code; None in the interpreter's own code."""
    return owner.get()


def program_folder() -> Path:
    """Return the folder where relative paths of the calling program begin.

    >>> program_folder().as_posix()
    '.'
    """
    process = current_process()
    return Path() if process is None else Path(process.cwd)


def outside(function: Callable[..., Any], *args: Any) -> Any:
    """Call a function as the interpreter's own code, and return its result.

    Threads started by it belong to no process: a process does not wait for them at its end.
    """
    return contextvars.Context().run(function, *args)
