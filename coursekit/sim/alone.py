"""A lock for one thread at a time: C walks through lists of bodies that another thread would change meanwhile."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any, TypeVar

Method = TypeVar("Method", bound=Callable[..., Any])


def alone(method: Method) -> Method:
    """A method whose object has a reentrant lock `busy`, which is held while the method runs."""

    @functools.wraps(method)
    def held(self: Any, *args: Any, **named: Any) -> Any:
        with self.busy:
            return method(self, *args, **named)

    return held  # type: ignore[return-value]
