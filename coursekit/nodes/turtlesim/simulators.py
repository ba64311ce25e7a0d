"""The turtlesims that run in a session, for the code that draws them."""

from __future__ import annotations

from typing import Any, Protocol

from coursekit.processes.live_things import LiveThings
from coursekit.sim.turtle import World


class Simulator(Protocol):
    """A running turtlesim."""

    world: World
    session: Any
    running: bool
    frames: int

    @property
    def full_name(self) -> str: ...
    @property
    def namespace(self) -> str: ...

    def background(self) -> tuple[int, int, int]: ...


simulators = LiveThings[Simulator]("turtlesim")
