"""pytest's plugin: launches for fixtures of `launch_pytest.fixture`, and runs tests during the launch or after it.

Every run of pytest loads this module. The rest is imported when a test has the mark `launch`.
"""

from __future__ import annotations

import importlib
from collections.abc import Generator
from typing import Any

import pytest

from .fixture import (
    ATTRIBUTE,
    get_event_loop_fixture,
    get_launch_context_fixture,
    get_launch_service_fixture,
)

event_loop = get_event_loop_fixture()
launch_service = get_launch_service_fixture()
launch_context = get_launch_context_fixture()


class LaunchTestWarning(pytest.PytestWarning):
    """A test has an invalid mark `launch`."""


def pytest_configure(config: Any) -> None:
    """Register the mark."""
    config.addinivalue_line(
        "markers",
        "launch: mark the test as a launch test, it will be run using the specified launch_pad.",
    )
    if config.pluginmanager.hasplugin("pytester"):
        # pytester discards the modules that a test imported, but these change the interpreter and must be imported only once
        importlib.import_module("coursekit.processes.session")
        importlib.import_module("launch")


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_fixture_setup(fixturedef: Any, request: Any) -> Generator[None, Any, Any]:
    """Launch the description that a launch fixture returns, and wait until the tests may begin."""
    known = getattr(fixturedef.func, ATTRIBUTE, None)
    if known is None:
        return (yield)
    from .launching import launch

    service, loop = request.getfixturevalue("launch_service"), request.getfixturevalue("event_loop")
    value = yield
    launch(value, known, service, loop, fixturedef.addfinalizer)
    return value


@pytest.hookimpl(tryfirst=True)
def pytest_pycollect_makeitem(collector: Any, name: str, obj: Any) -> Any:
    """Collect a test with the mark, whether it is a function, a generator or a coroutine."""
    if isinstance(obj, type) or not collector.istestfunction(obj, name):
        return None
    marks = getattr(obj, "pytestmark", None)
    own = marks if isinstance(marks, list) else [marks]
    mark = next((mark for mark in own if getattr(mark, "name", "") == "launch"), None)
    mark = mark or collector.get_closest_marker("launch")
    if mark is None:
        return None
    from .collecting import items_of

    return items_of(collector, name, obj, mark)


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(items: list[Any]) -> None:
    """Move tests that run after a launch behind those that run during it."""
    if any(item.get_closest_marker("launch") for item in items):
        from .collecting import put_after

        put_after(items)


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_pyfunc_call(pyfuncitem: Any) -> Generator[None, Any, Any]:
    """Run a test with the mark during its launch, or after it."""
    if not hasattr(pyfuncitem, ATTRIBUTE):
        return (yield)
    from .running import runner_of

    original = pyfuncitem.obj
    pyfuncitem.obj = runner_of(pyfuncitem)
    try:
        return (yield)
    finally:
        pyfuncitem.obj = original  # another plugin may run the test again
