"""Runs a launch test in the session, and connects programs outside the session to it."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TypeVar

from coursekit.processes.current_process import current_process
from coursekit.processes.session import current
from coursekit.wiring import HOLDER, SERVE, load

Result = TypeVar("Result")
DOMAINS = range(101)
NAME = "a launch test"


def in_session(function: Callable[[], Result]) -> Result:
    """Return the result of `function`, or raise its exception.

    On the virtual clock it runs as a process of the session; its waits then take no time.
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
    """Connect a test's nodes with `ros2` and node programs that run in parallel or that the test starts in a shell.

    The test stays in its domain, unless a notebook or another test holds the domain's terminals. It then gets a free domain.
    On the virtual clock these programs have sessions of their own.
    """
    if current().clock.virtual or current_process() is not None:
        yield
        return
    before = os.environ.get("ROS_DOMAIN_ID")
    domain, server = _choose(before or "")
    os.environ["ROS_DOMAIN_ID"] = str(domain)
    try:
        yield
    finally:
        if server is not None:
            server.close()
        os.environ.pop("ROS_DOMAIN_ID")
        if before is not None:
            os.environ["ROS_DOMAIN_ID"] = before


def _choose(wanted: str) -> tuple[int, Any]:
    """A domain, and the server that connects its terminals to the test; None if the commands' own session has them."""
    for domain in [int(wanted)] if wanted.isdecimal() else DOMAINS:
        server = load(SERVE)(current(), domain, NAME)
        if server is not None or wanted.isdecimal() or load(HOLDER)(domain) == "":
            current().meet(domain)
            return domain, server
    return DOMAINS[0], None
