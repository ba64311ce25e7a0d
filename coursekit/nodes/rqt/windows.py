"""The windows of rqt that run in a session, for the code that draws them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from coursekit.processes.live_things import LiveThings


@dataclass(eq=False)
class RqtWindow:
    """A running window."""

    kind: str
    """`rqt_graph`, `rqt_console`, `rqt_plot` or `rqt_gui`."""
    session: Any
    picture: str = ""
    """The name of the OpenCV window in which it draws; empty for a panel."""
    running: bool = True


windows = LiveThings[RqtWindow]("rqt")
