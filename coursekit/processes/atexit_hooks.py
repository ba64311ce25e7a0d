"""`atexit` per process: functions registered by a program run when it ends, not when the interpreter does.

Functions registered by libraries (such as weakref's finalizers) belong to the interpreter, whichever process loaded them.
"""

from __future__ import annotations

import atexit
import functools
import sys
from collections.abc import Callable
from typing import Any

from coursekit.systems.library_files import is_library_file

from .current_process import current_process

_register, _unregister = atexit.register, atexit.unregister


def _is_program(globals_of_caller: dict[str, Any]) -> bool:
    """Whether code belongs to a program: neither to Python, nor to a library, nor to coursekit."""
    file = globals_of_caller.get("__file__")
    return file is None or not is_library_file(file)


def register(func: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Callable[..., Any]:
    """`atexit.register` for the process of the calling program."""
    process = current_process()
    if process is None or not _is_program(sys._getframe(1).f_globals):
        return _register(func, *args, **kwargs)
    process.at_exit.append(functools.partial(func, *args, **kwargs))
    return func


def unregister(func: Callable[..., Any], /) -> None:
    """`atexit.unregister` for the calling process and for the interpreter."""
    process = current_process()
    _unregister(func)
    if process is not None:
        process.at_exit[:] = [kept for kept in process.at_exit if kept.func != func]


__all__ = ["register", "unregister"]
