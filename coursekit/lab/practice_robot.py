"""A practice robot in its own process beside the kernel: a network like a real one, on loopback."""

from __future__ import annotations

import os
import secrets
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

from coursekit.processes.base_process import BaseProcess
from coursekit.processes.child import ChildProcess
from coursekit.processes.session import NETWORK_VARIABLE, current
from coursekit.systems.ports import free_port

from .errors import NotNow
from .magics import show_as
from .terminal import Terminal
from .waiting import until_said

if TYPE_CHECKING:
    from coursekit.net.weak_link import WeakLink

NAME = "practice_robot"
READY = "Wheels and laser are ready"
USER = "practice"
START_SECONDS = 90.0
"""The timeout of the start [s]: the first one compiles the laser code, which takes a slow machine a minute."""


class PracticeRobot(Terminal):
    """The robot's own terminal; `address` is the network address to join."""

    address = ""

    def stop(self) -> None:
        """Switch the robot off."""
        self.process.interrupt()
        if self.process.wait(5.0) is None:
            self.process.kill()
            self.process.wait(2.0)


def practice_robot(world: str = "robot_world") -> PracticeRobot:
    """Start a robot in a simulated world, in its own process; a running one is switched off first.

    It can be reached only from this computer, with the password set in this notebook's environment. It ends with
    `stop()`, with `reset()`, and with the kernel.

        vera = practice_robot()
        %network {vera.address}

    In ROS 2: nothing; there you have a robot.
    """
    _check()
    for running in [running for running in current().processes if running.name == NAME]:
        running.kill()
        running.wait(2.0)
    address, password = f"tcp/127.0.0.1:{free_port()}", secrets.token_urlsafe(16)
    with tempfile.TemporaryDirectory(prefix="coursekit-") as folder:
        users = Path(folder) / "users.txt"
        users.write_text(f"{USER}:{password}\n", encoding="utf-8")
        process = current().launch(_program(address, users, world))
        until_said(process, READY, most=START_SECONDS)
    if READY not in process.output:
        process.kill()
        process.wait(2.0)
        raise NotNow(f"The practice robot did not start. What it said:\n{process.output.strip()}")
    _let_in(process, password)
    shown = PracticeRobot(process, NAME)
    shown.address = address
    show_as(NAME, shown)
    return shown


def weak_link(address: str) -> WeakLink:
    """Make a link with faults like bad Wi-Fi: `slow`, `late`, `cut`, `mend`; join its `address` instead."""
    from coursekit.net.weak_link import WeakLink

    return WeakLink(address)


def _check() -> None:
    """Raise an error for missing requirements before anything is started."""
    from coursekit.net.errors import NoNetwork
    from coursekit.net.zenoh_session import engine

    if current().clock.virtual:
        raise NotNow("A session on the virtual clock joins no network, and a robot needs one: use the wall clock.")
    try:
        engine()
    except NoNetwork as error:
        raise NotNow(str(error)) from None


def _program(address: str, users: Path, world: str) -> ChildProcess:
    command = [sys.executable, "-m", "coursekit.cli.coursekit", "network", "robot", "--until-input-ends"]
    command += ["--listen", address, "--users", str(users), "--world", world]
    env = {name: value for name, value in os.environ.items() if name not in ("COURSEKIT_TIME", "COURSEKIT_STOP_AFTER")}
    return ChildProcess(current(), command, name=NAME, env=env | {"PYTHONUNBUFFERED": "1"}, one_stream=True)


def _let_in(process: BaseProcess, password: str) -> None:
    """Provide the password to `%network` for as long as the robot runs."""
    theirs = {f"{NETWORK_VARIABLE}_USER": USER, f"{NETWORK_VARIABLE}_PASSWORD": password}
    os.environ |= theirs

    def forget(_process: object) -> None:
        if os.environ.get(f"{NETWORK_VARIABLE}_PASSWORD") == password:
            for name in theirs:
                os.environ.pop(name, None)

    process.on_exit(forget)


__all__ = ["PracticeRobot", "practice_robot", "weak_link"]
