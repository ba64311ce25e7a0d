"""Marks of test descriptions and of tests."""

from __future__ import annotations

import functools
import inspect
import time
from collections.abc import Callable
from typing import Any, TypeVar

Described = TypeVar("Described", bound=Callable[..., Any])


def keep_alive(test_description: Described) -> Described:
    """Keep the launch running after all its processes have ended, until the tests have ended, too."""
    if not hasattr(test_description, "__markers__"):
        test_description.__markers__ = {}  # type: ignore[attr-defined]
    test_description.__markers__["keep_alive"] = True  # type: ignore[attr-defined]
    return test_description


def retry_on_failure(*, times: int, delay: float | None = None) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Run a test up to `times` times, `delay` seconds apart, until none of its assertions fails.

    Raises:
        AssertionError: when `times` is not positive, or the decorated object is not a method.
    """
    assert times > 0, f"'times' is {times}, but a test has to be tried at least once"

    def decorate(test: Callable[..., Any]) -> Callable[..., Any]:
        assert next(iter(inspect.signature(test).parameters), None) == "self", (
            f"retry_on_failure decorates methods of test cases, and '{test.__name__}' is none"
        )

        @functools.wraps(test)
        def attempts(self: Any, *args: Any, **kwargs: Any) -> Any:
            for _ in range(times - 1):
                failures = _Failures(self)
                try:
                    result = test(self, *args, **kwargs)
                    failures.check()
                    return result
                except AssertionError:
                    failures.forget()
                if delay is not None:
                    time.sleep(delay)
            return test(self, *args, **kwargs)

        return attempts

    return decorate


class _Failures:
    """The failures of sub-tests in one attempt of a unittest case, without the exception that it raised."""

    def __init__(self, case: Any) -> None:
        self.outcome = getattr(case, "_outcome", None)
        holders = (self.outcome, getattr(self.outcome, "result", None))  # the second since Python 3.11
        lists = (getattr(holder, name, None) for holder in holders for name in ("errors", "failures"))
        self.lists = [(group, len(group)) for group in lists if group is not None]

    def check(self) -> None:
        """Raise AssertionError if a sub-test has failed."""
        assert self.outcome is None or self.outcome.success, "a sub-test has failed"

    def forget(self) -> None:
        """Remove the failures that the attempt recorded."""
        for recorded, before in self.lists:
            del recorded[before:]
        if self.outcome is not None:
            self.outcome.success = True
