"""The process whose code is running, kept in a context variable."""

from __future__ import annotations

import contextvars
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .process import Process

owner: contextvars.ContextVar[Process | None] = contextvars.ContextVar("coursekit_process", default=None)


def current_process() -> Process | None:
    """The process in which the calling code runs; None in the interpreter's own code."""
    return owner.get()


def outside(function: Callable[..., Any], *args: Any) -> Any:
    """The result of a function that is carried out as the interpreter's own code.

    Threads that it starts belong to no process: a process that ends does not wait for them.
    """
    return contextvars.Context().run(function, *args)
