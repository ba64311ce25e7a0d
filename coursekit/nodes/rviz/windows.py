"""The rviz2 nodes that run in a session, for the code that draws their windows."""

from __future__ import annotations

from typing import Any, Protocol

from coursekit.processes.live_things import LiveThings

from .config import Config


class RvizWindow(Protocol):
    """A running rviz2."""

    session: Any
    config: Config
    running: bool

    @property
    def full_name(self) -> str: ...


windows = LiveThings[RvizWindow]("rviz2")
