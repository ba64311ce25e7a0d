"""The items of tests with the mark `launch`, and their order."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import pytest

from .fixture import ATTRIBUTE, LaunchFixture
from .plugin import LaunchTestWarning

NO_FIXTURE = '"fixture" keyword argument is required in a pytest.mark.launch() decorator'


@dataclass
class LaunchTest:
    """The data of an item: its fixture, whether it runs after the launch, and the second half of a generator."""

    fixture: LaunchFixture
    shutdown: bool
    second_half: Any = None
    generator: Any = None


def items_of(collector: Any, name: str, function: Callable[..., Any], mark: pytest.Mark) -> list[Any]:
    """Return the items of a test; a generator on a shared launch has a second item, which runs after the launch."""
    known = getattr(mark.kwargs.get("fixture"), ATTRIBUTE, None)
    if known is None:
        return [_left_out(collector, name)]
    pytest.mark.usefixtures(known.name, "launch_service", "event_loop")(function)
    items = list(collector._genfunctions(name, function))
    for item in items:
        setattr(item, ATTRIBUTE, LaunchTest(known, bool(mark.kwargs.get("shutdown", False))))
    if known.scope == "function" or not is_generator(function):
        return items
    return [*items, *(_second_half(item, known) for item in items)]


def is_generator(function: Callable[..., Any]) -> bool:
    """Whether a test has a part during the launch and a part after it."""
    return inspect.isgeneratorfunction(function) or inspect.isasyncgenfunction(function)


def _second_half(item: Any, known: LaunchFixture) -> Any:
    half = pytest.Function.from_parent(
        item.parent,
        name=f"{item.name}[shutdown_test]",
        originalname=f"{item.originalname}[shutdown_test]",
        callobj=item.obj,
        callspec=getattr(item, "callspec", None),
        fixtureinfo=item._fixtureinfo,
    )
    setattr(half, ATTRIBUTE, LaunchTest(known, shutdown=True))
    getattr(item, ATTRIBUTE).second_half = half
    return half


def _left_out(collector: Any, name: str) -> Any:
    item = pytest.Function.from_parent(collector, name=name)
    item.warn(LaunchTestWarning(NO_FIXTURE))
    item.add_marker(pytest.mark.skip(NO_FIXTURE))
    return item


def put_after(items: list[Any]) -> None:
    """Move each test that runs after a launch behind the last test that runs during the same launch."""
    for item in [test for test in reversed(items) if _launch_of(test) is not None and getattr(test, ATTRIBUTE).shutdown]:
        at = items.index(item)
        beside = [
            number
            for number, other in enumerate(items)
            if number > at and _launch_of(other) == _launch_of(item) and not getattr(other, ATTRIBUTE).shutdown
        ]
        if beside:
            items.insert(beside[-1], items.pop(at))


def _launch_of(item: Any) -> tuple[Any, ...] | None:
    """The shared launch of a test; None for a test with a launch of its own or without a launch."""
    test = getattr(item, ATTRIBUTE, None)
    if test is None or test.fixture.scope == "function":
        return None
    callspec = getattr(item, "callspec", None)
    return test.fixture, None if callspec is None else callspec.params.get(test.fixture.name)
