"""The base class of all conditions."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .launch_context import LaunchContext


class Condition:
    """Wraps a predicate that decides, while launching, whether an action is executed."""

    def __init__(self, *, predicate: Callable[[LaunchContext], bool] | None = None) -> None:
        self._predicate = predicate
        self.__last_result: bool | None = None

    def evaluate(self, context: LaunchContext) -> bool:
        """Return whether the condition is true now, and remember the result."""
        self.__last_result = self._predicate(context) if self._predicate is not None else True
        return self.__last_result

    def describe(self) -> str:
        """Return a short description of this condition."""
        return repr(self)

    @property
    def last_result(self) -> bool | None:
        """The latest result of `evaluate`; None before the first."""
        return self.__last_result
