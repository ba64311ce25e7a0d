"""The joint_state_publisher_gui nodes that run in a session, for the code that draws their sliders."""

from __future__ import annotations

from typing import Any, Protocol

from coursekit.nodes.robots.joint_model import JointModel
from coursekit.processes.live_things import LiveThings


class Board(Protocol):
    """A running joint_state_publisher_gui."""

    session: Any
    running: bool
    model: JointModel

    @property
    def full_name(self) -> str: ...

    def move(self, name: str, position: float) -> None: ...
    def center(self) -> None: ...
    def randomize(self) -> None: ...


boards = LiveThings[Board]("joint_state_publisher_gui")
