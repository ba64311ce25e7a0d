"""The time line: all panels of the notebook go back together over what they have shown."""

from __future__ import annotations

import math
from typing import Any

from .panel import Panel, open_panels, static
from .past import SECONDS

STEP_SECONDS = 0.1
"""While it plays, the panels go on so often [s]."""


class Timeline(Panel):
    """See `timeline`."""

    _esm = static("timeline.js")
    _css = static("timeline.css")

    def __init__(self) -> None:
        super().__init__()
        self._playing = False
        self._told: Any = None
        self._clock = self.session.clock

    def begin(self) -> int:
        """The oldest time that any panel has [ns]."""
        now = self._clock.steady()
        times = [one.known_since() for one in open_panels()]
        return max(min([now, *(time for time in times if time is not None)]), now - round(SECONDS * 1e9))

    # -- from code

    @property
    def ago(self) -> float:
        """How long ago was what the panels show [s]; 0 while they show what happens."""
        time = self.cursor.time
        return 0.0 if time is None else (self._clock.steady() - time) * 1e-9

    def back(self, seconds: float) -> None:
        """Have the panels show what there was so many seconds ago, and stay there."""
        self._playing = False
        self.cursor.go(max(self.begin(), self._clock.steady() - round(seconds * 1e9)))

    def play(self) -> None:
        """Have them go on from there, until they show what happens now."""
        if self.cursor.time is not None and not self._playing:
            self._playing = True
            self.session.spawn(self._play)
            self.changed()

    def pause(self) -> None:
        """Have them stay at what they show now."""
        self._playing = False
        self.cursor.go(self._clock.steady() if self.cursor.time is None else self.cursor.time)

    def live(self) -> None:
        """Have them show what happens."""
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
        """Where the panels are."""
        reach = (self._clock.steady() - self.begin()) * 1e-9
        return f"time line of {reach:.1f} s: " + (f"{self.ago:.1f} s ago" if self.cursor.time is not None else "now")

    def shown(self) -> dict[str, Any]:
        """The reach of the past, and how long ago is what is shown [s]."""
        self.look_again(0.5)
        reach, live = (self._clock.steady() - self.begin()) * 1e-9, self.cursor.time is None
        return {"reach": round(reach, 2), "ago": round(self.ago, 2), "live": live, "playing": self._playing}

    def look_back(self) -> None:
        """The cursor has moved."""
        self.changed()

    def on_go(self, message: dict[str, Any]) -> None:
        """The slider was moved."""
        ago = message.get("ago")
        if isinstance(ago, int | float) and math.isfinite(ago):
            self.back(max(0.0, ago))

    def on_press(self, message: dict[str, Any]) -> None:
        """A button was pressed."""
        does = {"play": self.play, "pause": self.pause, "live": self.live}.get(str(message.get("button")))
        if does is not None:
            does()
            self._push()

    def leave(self) -> None:
        """Without a time line nothing would lead back to what happens."""
        self.live()


def timeline() -> Timeline:
    """A time line under the panels of this notebook: viewer, world, graph, frames and plots go back together.

    They keep what they have shown on a page, for five minutes at most. `desk(viewer(), timeline())` docks it below.
    """
    return Timeline()


__all__ = ["Timeline", "timeline"]
