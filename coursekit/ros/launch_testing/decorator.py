"""The decorator of test classes that run when all processes have ended."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

Case = TypeVar("Case", bound=type)


def post_shutdown_test() -> Callable[[Case], Case]:
    """Run the tests of a class after the launch has ended.

    >>> @post_shutdown_test()
    ... class TestExitCodes:
    ...     pass
    >>> TestExitCodes.__post_shutdown_test__
    True

    Raises:
        TypeError: when it decorates an object that is not a class.
    """

    def decorate(case: Case) -> Case:
        if not isinstance(case, type):
            raise TypeError(f"post_shutdown_test decorates test classes, and this is a {type(case).__name__}")
        case.__post_shutdown_test__ = True  # type: ignore[attr-defined]
        return case

    return decorate
