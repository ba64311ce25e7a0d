"""Runs a test during its launch, or after it: coroutines on the launch's loop, other tests in a separate thread."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from coursekit.processes.patching import patch_manager

from .collecting import LaunchTest, is_generator
from .fixture import ATTRIBUTE, finalize_launch_service

Runner = Callable[..., None]


def runner_of(item: Any) -> Runner:
    """Return the function that runs an item's test, with its arguments."""
    patch_manager.renew()  # pytest has replaced them since the launch began
    function, test = item.obj, getattr(item, ATTRIBUTE)
    stages = _Stages(function, test, item.funcargs["launch_service"], item.funcargs["event_loop"])
    if not is_generator(function):
        return stages.whole
    if item.get_closest_marker("launch").kwargs.get("shutdown"):
        return _not_both
    if test.fixture.scope == "function":
        return stages.both_halves
    return stages.second_half if test.shutdown else stages.first_half


def _not_both(**_: Any) -> None:
    pytest.fail("generator or async generator based launch test items cannot be marked with shutdown=True")


class _Stages:
    """The modes in which a test runs."""

    def __init__(self, function: Callable[..., Any], test: LaunchTest, service: Any, loop: Any) -> None:
        self._function = function
        self._test = test
        self._service = service
        self._loop = loop

    def whole(self, **arguments: Any) -> None:
        if self._test.shutdown:
            self._end_launch()
        self._run(self._function, arguments)

    def both_halves(self, **arguments: Any) -> None:
        generator = self._function(**arguments)
        self._advance(generator)
        self._end_launch()
        self._finish(generator)

    def first_half(self, **arguments: Any) -> None:
        generator = self._function(**arguments)
        self._advance(generator)
        getattr(self._test.second_half, ATTRIBUTE).generator = generator

    def second_half(self, **_: Any) -> None:
        if self._test.generator is None:
            pytest.skip("shutdown test skipped because the test failed before")
        self._end_launch()
        self._finish(self._test.generator)

    def _end_launch(self) -> None:
        finalize_launch_service(
            self._service,
            eprefix=f"When running test {self._function.__name__}",
            auto_shutdown=self._test.fixture.auto_shutdown,
        )

    def _run(self, function: Callable[..., Any], arguments: dict[str, Any]) -> None:
        if inspect.iscoroutinefunction(function):
            self._loop.run_until_complete(function(**arguments))
        else:
            self._loop.run_until_complete(self._loop.run_in_executor(None, functools.partial(function, **arguments)))

    def _advance(self, generator: Any) -> None:
        """Run a generator to its next yield or its end."""
        if inspect.isasyncgen(generator):
            self._loop.run_until_complete(_next(generator))
        else:
            self._run(_step, {"generator": generator})

    def _finish(self, generator: Any) -> None:
        try:
            self._advance(generator)
        except _Ended:
            return
        kind = "an async gen" if inspect.isasyncgen(generator) else "a generator"
        pytest.fail(f"launch tests using {kind} function must stop iteration after yielding once", pytrace=False)


class _Ended(Exception):
    """A generator has no further yield. It replaces StopIteration, which a future cannot raise."""

    def __init__(self) -> None:
        super().__init__("the test has ended before its yield: what is to run after the launch comes after a yield")


def _step(generator: Iterator[Any]) -> None:
    try:
        next(generator)
    except StopIteration:
        raise _Ended from None


async def _next(generator: Any) -> None:
    try:
        await generator.__anext__()
    except StopAsyncIteration:
        raise _Ended from None
