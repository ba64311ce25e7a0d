"""`atexit` of each process: what it registers runs when it ends, not when the interpreter does."""

from __future__ import annotations

import atexit
import functools
from collections.abc import Callable
from typing import Any

from .whose import current_process

_register, _unregister = atexit.register, atexit.unregister


def register(func: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Callable[..., Any]:
    """`atexit.register`, of the process that asks."""
    process = current_process()
    if process is None:
        return _register(func, *args, **kwargs)
    process.at_exit.append(functools.partial(func, *args, **kwargs))
    return func


def unregister(func: Callable[..., Any], /) -> None:
    """`atexit.unregister`, of the process that asks."""
    process = current_process()
    if process is None:
        _unregister(func)
    else:
        process.at_exit[:] = [kept for kept in process.at_exit if kept.func != func]


def install() -> None:
    """Put these in place of the standard ones; harmless when they are."""
    atexit.register, atexit.unregister = register, unregister


def at_interpreter_exit(func: Callable[..., Any], /, *args: Any, **kwargs: Any) -> None:
    """`atexit.register` of the interpreter, whichever process asks."""
    _register(func, *args, **kwargs)


__all__ = ["at_interpreter_exit", "install"]
