"""The launch of the description that a fixture returns."""

from __future__ import annotations

import asyncio
import functools
from collections.abc import Callable, Sequence
from typing import Any

from launch import LaunchDescription, LaunchService
from launch_testing.actions import ReadyToTest
from launch_testing.loader import find_ready_actions

from .fixture import LaunchFixture, finalize_launch_service


def launch(
    value: Any,
    known: LaunchFixture,
    service: LaunchService,
    loop: Any,
    add_finalizer: Callable[[Callable[[], None]], None],
) -> None:
    """Launch the description that a fixture returned, and wait for its ReadyToTest action, which is added if missing.

    Raises:
        AssertionError: when there is no description.
        RuntimeError: when it has several ReadyToTest actions, or the launch ended before the action was executed.
    """
    prefix = f"When running launch_pytest fixture '{known.name}':"
    description = _description(value, prefix)
    service.include_launch_description(description)
    running = loop.create_task(service.run_async(shutdown_when_idle=known.shutdown_when_idle))
    ready = loop.create_future()
    _ready_action(description)._add_callback(lambda: ready.done() or ready.set_result(None))
    add_finalizer(functools.partial(finalize_launch_service, service, eprefix=prefix, auto_shutdown=known.auto_shutdown))
    loop.run_until_complete(_first(running, ready))
    if not ready.done():
        raise RuntimeError(f"{prefix} the launch ended before the ReadyToTest action was carried out")


def _description(value: Any, prefix: str) -> LaunchDescription:
    wrong = (
        f"{prefix} return value must be either a launch description or a sequence which first item is a launch description"
    )
    if isinstance(value, Sequence):
        assert len(value) > 0, wrong
        value = value[0]
    assert isinstance(value, LaunchDescription), wrong
    return value


def _ready_action(description: LaunchDescription) -> ReadyToTest:
    actions = list(find_ready_actions(description.entities))
    if len(actions) > 1:
        raise RuntimeError("launch_pytest fixtures must return a LaunchDescription containing only one ReadyToTest action")
    if not actions:
        actions = [ReadyToTest()]
        description.add_action(actions[0])
    return actions[0]


async def _first(*futures: Any) -> None:
    await asyncio.wait(futures, return_when=asyncio.FIRST_COMPLETED)
