"""A lock for one thread at a time: C iterates over lists of bodies that another thread might change."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any, TypeVar

Method = TypeVar("Method", bound=Callable[..., Any])


def alone(method: Method) -> Method:
    """Wrap a method to hold the object's reentrant lock `busy` while it runs."""

    @functools.wraps(method)
    def held(self: Any, *args: Any, **named: Any) -> Any:
        with self.busy:
            return method(self, *args, **named)

    return held  # type: ignore[return-value]
