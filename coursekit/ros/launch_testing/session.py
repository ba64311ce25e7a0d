"""Runs a launch test in the session, and lets programs that it starts outside of the session in."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TypeVar

from coursekit.core.commands import DOOR, load
from coursekit.core.session import current
from coursekit.core.whose import current_process

Result = TypeVar("Result")
DOMAINS = range(1, 101)


def in_session(function: Callable[[], Result]) -> Result:
    """Return what `function` returns, or raise what it raises.

    On the virtual clock it runs as a process of the session, so that its waiting takes no time.
    """
    session = current()
    if not session.clock.virtual or current_process() is not None:
        return function()
    outcome: list[Any] = []

    def main() -> None:
        try:
            outcome.append((function(), None))
        except BaseException as error:
            outcome.append((None, error))

    streams = {"stdout": sys.stdout, "stderr": sys.stderr}

    def show(stream: str, text: str) -> None:
        streams[stream].write(text)

    session.start(main, name="launch_test", on_output=show).wait()
    result, error = outcome[0]
    if error is not None:
        raise error
    return result  # type: ignore[no-any-return]


@contextmanager
def own_domain() -> Iterator[None]:
    """Let `ros2` and node programs that a test starts by `subprocess` or a shell join the session under test.

    For this the test gets a ROS domain that no other session on this computer has, unless one is set. On the virtual clock
    such programs have sessions of their own.
    """
    door = None if current().clock.virtual or current_process() is not None else _open_door()
    before = os.environ.get("ROS_DOMAIN_ID")
    if door is not None:
        os.environ["ROS_DOMAIN_ID"] = str(door.domain_id)
    try:
        yield
    finally:
        if door is not None:
            door.close()
            os.environ.pop("ROS_DOMAIN_ID")
            if before is not None:
                os.environ["ROS_DOMAIN_ID"] = before


def _open_door() -> Any:
    wanted = os.environ.get("ROS_DOMAIN_ID", "")
    domains = [int(wanted)] if wanted.isdecimal() else DOMAINS
    doors = (load(DOOR)(current(), domain) for domain in domains)
    return next((door for door in doors if door is not None), None)
