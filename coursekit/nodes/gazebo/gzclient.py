"""`gzclient`: Gazebo's window. It opens in the notebook, if there is one; else a message names the alternative."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from coursekit.nodes.running import to_the_end
from coursekit.processes.live_things import LiveThings
from coursekit.processes.session import current

NO_WINDOW = "gzclient: no notebook shows this window. Look at the world in one, with world_view()."


@dataclass(eq=False)
class WorldWindow:
    """A running window of Gazebo."""

    session: Any
    running: bool = True


windows = LiveThings[WorldWindow]("gzclient")


def main() -> int:
    """Show the world until Ctrl-C, even if no notebook draws it: launch files end everything when it ends."""
    window = WorldWindow(current())
    with to_the_end():
        if not windows.tell(window):
            print(NO_WINDOW)
        try:
            window.session.clock.new_event().wait()
        finally:
            window.running = False
            windows.tell(window)
    return 0
