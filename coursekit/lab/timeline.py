"""The time line: all panels of the notebook go back together through their history."""

from __future__ import annotations

import math
from typing import Any

from .panel import Panel, open_panels, static
from .panel_history import SECONDS

STEP_SECONDS = 0.1
"""The update period of the panels during playback [s]."""


class Timeline(Panel):
    """See `timeline`."""

    _esm = static("timeline.js")
    _css = static("timeline.css")

    def __init__(self) -> None:
        super().__init__()
        self._playing = False
        self._clock = self.session.clock

    def begin(self) -> int:
        """Return the oldest time recorded by any panel [ns]."""
        now = self._clock.steady()
        times = [panel.known_since() for panel in open_panels()]
        return max(min([now, *(time for time in times if time is not None)]), now - round(SECONDS * 1e9))

    # -- from code

    @property
    def ago(self) -> float:
        """The age of the content that the panels show [s]; 0 while they are live."""
        time = self.cursor.time
        return 0.0 if time is None else (self._clock.steady() - time) * 1e-9

    def back(self, seconds: float) -> None:
        """Show the state of `seconds` ago in the panels, and pause there."""
        self._playing = False
        self.cursor.go(max(self.begin(), self._clock.steady() - round(seconds * 1e9)))

    def play(self) -> None:
        """Play from there until the panels are live again."""
        if self.cursor.time is not None and not self._playing:
            self._playing = True
            self.session.spawn(self._play)
            self.changed()

    def pause(self) -> None:
        """Pause the panels at the time that they show."""
        self._playing = False
        self.cursor.go(self._clock.steady() if self.cursor.time is None else self.cursor.time)

    def live(self) -> None:
        """Make the panels live again."""
        self._playing = False
        self.cursor.go(None)

    def _play(self) -> None:
        while self._playing and not self.closed and self.cursor.time is not None:
            self._clock.sleep(STEP_SECONDS)
            time = self.cursor.time + round(STEP_SECONDS * 1e9) if self.cursor.time is not None else None
            if self._playing and time is not None:
                self.cursor.go(time if time < self._clock.steady() - round(STEP_SECONDS * 1e9) else None)
        self._playing = False
        self.changed()

    # -- what is shown

    def text(self) -> str:
        """Return the time shown by the panels."""
        reach = (self._clock.steady() - self.begin()) * 1e-9
        return f"time line of {reach:.1f} s: " + (f"{self.ago:.1f} s ago" if self.cursor.time is not None else "now")

    def shown(self) -> dict[str, Any]:
        """Return the length of the history and the age of the shown content [s]."""
        self.look_again(0.5)
        reach, live = (self._clock.steady() - self.begin()) * 1e-9, self.cursor.time is None
        return {"reach": round(reach, 2), "ago": round(self.ago, 2), "live": live, "playing": self._playing}

    def look_back(self) -> None:
        """Handle a moved cursor."""
        self.changed()

    def on_go(self, message: dict[str, Any]) -> None:
        """Handle the slider."""
        ago = message.get("ago")
        if isinstance(ago, int | float) and math.isfinite(ago):
            self.back(max(0.0, ago))

    def on_press(self, message: dict[str, Any]) -> None:
        """Handle a button."""
        does = {"play": self.play, "pause": self.pause, "live": self.live}.get(str(message.get("button")))
        if does is not None:
            does()
            self._push()

    def leave(self) -> None:
        """Make the panels live again: without a time line nothing else would."""
        self.live()


def timeline() -> Timeline:
    """Show a time line for the panels of this notebook: viewer, world, graph, frames and plots go back together.

    They record the content shown on a page, for at most five minutes. `desk(viewer(), timeline())` docks it below.
    """
    return Timeline()


__all__ = ["Timeline", "timeline"]
