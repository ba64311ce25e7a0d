"""Pickles of a program's own classes: pickle looks them up in sys.modules, where a process's modules are not."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

from .private_modules import private_of_process


def with_own_modules(real: Callable[..., Any]) -> Callable[..., Any]:
    """A function of pickle's that finds the modules of the process that calls it."""

    @functools.wraps(real)
    def call(*args: Any, **kwargs: Any) -> Any:
        private = private_of_process()
        if private is None:
            return real(*args, **kwargs)
        with private.in_place_with_main():
            return real(*args, **kwargs)

    return call
