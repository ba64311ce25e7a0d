"""Fixtures that launch: the decorator, and the launch service, its context and its loop as fixtures."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import pytest

ATTRIBUTE = "_launch_pytest"
SCOPES = ("function", "class", "module", "package", "session")


@dataclass(frozen=True)
class LaunchFixture:
    """The data of a fixture that launches."""

    name: str
    scope: str
    shutdown_when_idle: bool
    auto_shutdown: bool


def fixture(
    decorated: Callable[..., Any] | None = None,
    *args: Any,
    shutdown_when_idle: bool = True,
    auto_shutdown: bool = True,
    **kwargs: Any,
) -> Any:
    """Make a fixture that launches the description that its function returns, alone or as the first item of a sequence.

    The arguments are those of `pytest.fixture`, `shutdown_when_idle`: whether the launch ends when all processes have ended,
    and `auto_shutdown`: whether it is shut down when its tests have ended. With a scope wider than a function's,
    `event_loop`, `launch_service` and `launch_context` get that scope in the module, too.
    """
    scope = str(kwargs.get("scope", "function"))
    _provide(sys._getframe(1).f_globals, scope)

    def decorate(function: Callable[..., Any]) -> Any:
        name = kwargs.get("name") or function.__name__
        setattr(function, ATTRIBUTE, LaunchFixture(name, scope, shutdown_when_idle, auto_shutdown))
        return pytest.fixture(function, *args, **kwargs)

    return decorate if decorated is None else decorate(decorated)


def _provide(namespace: dict[str, Any], scope: str) -> None:
    """Add the fixtures that a launch needs to a module, unless it defines its own or has them with a sufficient scope."""
    for name, make in MAKERS.items() if scope != "function" else ():
        present = namespace.get(name)
        made_for = getattr(present, ATTRIBUTE + "_scope", None)
        if present is None or (made_for is not None and SCOPES.index(made_for) < SCOPES.index(scope)):
            namespace[name] = make(scope=scope)


def _fixture(function: Callable[..., Any], scope: str) -> Any:
    setattr(function, ATTRIBUTE + "_scope", scope)
    return pytest.fixture(function, scope=scope)  # type: ignore[call-overload]


def get_event_loop_fixture(*, scope: str = "function") -> Any:
    """Return a fixture with the event loop of a launch and of the coroutines that test it."""

    def event_loop() -> Iterator[Any]:
        """The event loop of the launch and of tests that are coroutines."""
        import asyncio

        from launch.clock_loop import ClockLoop

        from coursekit.processes.session import current

        loop: Any = ClockLoop() if current().clock.virtual else asyncio.new_event_loop()  # type: ignore[abstract]
        asyncio.set_event_loop(loop)
        yield loop
        loop.close()
        asyncio.set_event_loop(None)

    return _fixture(event_loop, scope)


def get_launch_service_fixture(*, scope: str = "function") -> Any:
    """Return a fixture with the launch service."""

    def launch_service(event_loop: Any) -> Iterator[Any]:
        """The launch service."""
        from launch import LaunchService
        from launch_testing.session import own_domain

        with own_domain():
            service = LaunchService()
            yield service
            finalize_launch_service(service, eprefix="When tearing down launch_service fixture")

    return _fixture(launch_service, scope)


def get_launch_context_fixture(*, scope: str = "function") -> Any:
    """Return a fixture with the launch's context."""

    def launch_context(launch_service: Any) -> Any:
        """The launch's context, for `launch_pytest.tools`."""
        return launch_service.context

    return _fixture(launch_context, scope)


MAKERS = {
    "event_loop": get_event_loop_fixture,
    "launch_service": get_launch_service_fixture,
    "launch_context": get_launch_context_fixture,
}


def finalize_launch_service(launch_service: Any, eprefix: str = "", auto_shutdown: bool = True) -> None:
    """Wait for the end of a launch; with `auto_shutdown`, shut it down first.

    Raises:
        AssertionError: when the launch failed.
    """
    from coursekit.processes.patching import patch_manager

    patch_manager.renew()  # pytest may have replaced them since the launch began
    if auto_shutdown:
        launch_service.shutdown(force_sync=True)
    loop = launch_service.event_loop
    if loop is not None and not loop.is_closed():
        code = loop.run_until_complete(launch_service.task)
        assert code == 0, f"{eprefix} launch service failed when finishing, return code '{code}'"
