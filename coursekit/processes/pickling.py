"""Pickles of a program's own classes: pickle looks classes up in sys.modules, which lacks a process's private modules."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

from .private_modules import private_of_process


def with_own_modules(real: Callable[..., Any]) -> Callable[..., Any]:
    """Wrap a function of pickle so that it finds the modules of the calling process."""

    @functools.wraps(real)
    def call(*args: Any, **kwargs: Any) -> Any:
        private = private_of_process()
        if private is None:
            return real(*args, **kwargs)
        with private.in_place_with_main():
            return real(*args, **kwargs)

    return call
