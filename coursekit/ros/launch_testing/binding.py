"""Access of tests to their launch: attributes, and arguments of their methods."""

from __future__ import annotations

import functools
import inspect
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any


def iterate_tests(tests: Any) -> Iterator[Any]:
    """Yield each test of a suite and of the suites in it."""
    if isinstance(tests, Iterable):
        for test in tests:
            yield from iterate_tests(test)
    else:
        yield tests


def bind_arguments(values: Mapping[str, Any], tests: Any) -> None:
    """Pass each test, setUp, tearDown, setUpClass and tearDownClass the values whose names are among its parameters."""
    for test in iterate_tests(tests):
        for name in (test._testMethodName, "setUp", "tearDown"):
            setattr(test, name, _with(values, getattr(test, name)))
    for case in _classes(tests):
        for name in ("setUpClass", "tearDownClass"):
            setattr(case, name, _with(values, getattr(case, name)))


def _with(values: Mapping[str, Any], function: Callable[..., Any]) -> functools.partial[Any]:
    taken = inspect.signature(function).parameters
    return functools.partial(function, **{name: value for name, value in values.items() if name in taken})


def give_attributes(values: Mapping[str, Any], tests: Any) -> None:
    """Add attributes to the classes of tests, with a warning on the first use that recommends arguments."""
    for case in _classes(tests):
        for name, value in values.items():
            setattr(case, name, _attribute(name, value))


def _attribute(name: str, value: Any) -> property:
    def get(self: Any) -> Any:
        if not hasattr(self, "__warned"):
            warnings.warn(
                f"Automatically adding attributes like self.{name} to the test class will be deprecated in a future "
                f"release.  Instead, add {name} to the test method argument list to access the test object you need",
                stacklevel=2,
            )
            setattr(self, "__warned", True)
        return value

    return property(get)


def _classes(tests: Any) -> list[type]:
    return list(dict.fromkeys(type(test) for test in iterate_tests(tests)))
