"""The windows of rqt that run in a session, for the code that draws them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from coursekit.processes.live_things import LiveThings


@dataclass(eq=False)
class RqtWindow:
    """A running window."""

    kind: str
    """`rqt_graph`, `rqt_console`, `rqt_plot`, `rqt_reconfigure`, ...: the name of its package."""
    session: Any
    picture: str = ""
    """The name of the OpenCV window in which it draws; empty for a panel."""
    topic: str = ""
    """Where `rqt_robot_steering` publishes, ..."""
    speeds: tuple[float, float] = (0.0, 0.0)
    """... at most so many m/s and rad/s."""
    running: bool = True


windows = LiveThings[RqtWindow]("rqt")
