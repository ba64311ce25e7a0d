"""The windows that programs open with OpenCV: their images, keys, sliders and mouse; `highgui` has cv2's functions."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Any

import cv2
import numpy as np

from coursekit.processes.live_things import LiveThings
from coursekit.processes.process import current_process
from coursekit.processes.session import current

from .window_input import Mouse, Trackbar


class Window:
    """A named window with its newest image."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.title = name
        self.image: Any = None
        self.shown = 0
        """The number of images shown so far."""
        self.open = True
        self.owner = current_process()
        """The program that opened it; None for a cell."""
        self.trackbars: dict[str, Trackbar] = {}
        self.mouse: Mouse | None = None
        self.events: deque[Callable[[], None]] = deque(maxlen=1000)
        """What happened to its sliders and the mouse, until the program waits for a key."""

    def trackbar(self, name: str) -> Trackbar:
        """Return its slider of that name; cv2.error if there is none."""
        if name not in self.trackbars:
            known = ", ".join(self.trackbars) or "none"
            raise cv2.error(f"The window '{self.name}' has no trackbar '{name}'. It has: {known}.")
        return self.trackbars[name]

    def __repr__(self) -> str:
        size = "no image yet" if self.image is None else f"{self.image.shape[1]}x{self.image.shape[0]}"
        bars = "".join(f"; {bar.name}: {bar.value}" for bar in self.trackbars.values())
        return f"[window {self.name}: {size}{bars}]"


_windows = LiveThings[Window]("cv2")
watch = _windows.watch
unwatch = _windows.unwatch
tell = _windows.tell
"""Tell those who watch that a window has changed."""


class Desk:
    """The windows of one session, and the keys pressed in them."""

    def __init__(self, session: Any) -> None:
        self.session = session
        self.windows: dict[str, Window] = {}
        self.keys: deque[int] = deque(maxlen=100)
        self._pressed = session.clock.new_event()

    def window(self, name: str) -> Window:
        """Return the window of that name, opened on first use."""
        window = self.windows.get(name)
        if window is None:
            window = self.windows[name] = Window(name)
            tell(window)
        return window

    def open_window(self, name: str) -> Window:
        """Return the window of that name; cv2.error if there is none."""
        if name not in self.windows:
            known = ", ".join(self.windows) or "none"
            raise cv2.error(f"There is no window '{name}': cv2.namedWindow('{name}') opens it. There are: {known}.")
        return self.windows[name]

    def close(self, name: str) -> None:
        """Close a window; does nothing if there is none."""
        window = self.windows.pop(name, None)
        if window is not None:
            window.open = False
            tell(window)

    def press(self, key: str | int) -> None:
        """Press a key: a character, or a key code as returned by waitKey."""
        self.keys.append(ord(key) if isinstance(key, str) else int(key))
        self._pressed.set()

    def slide(self, window: str, name: str, value: int) -> None:
        """Pull a window's slider to a value, as a user does."""
        bar = self.open_window(window).trackbar(name)
        self._happen(self.windows[window], lambda: bar.move(value))

    def point(self, window: str, event: int, x: int, y: int, flags: int = 0) -> None:
        """Move or press the mouse at a pixel of a window; `event` is cv2.EVENT_MOUSEMOVE, cv2.EVENT_LBUTTONDOWN, ..."""
        there = self.windows.get(window)
        if there is not None and (mouse := there.mouse) is not None:
            self._happen(there, lambda: mouse.tell(event, x, y, flags))

    def _happen(self, window: Window, event: Callable[[], None]) -> None:
        window.events.append(event)
        self._pressed.set()

    def deliver(self) -> None:
        """Tell the calling program what happened to the sliders and the mouse in its windows."""
        program = current_process()
        for window in [one for one in self.windows.values() if one.owner is program]:
            while window.events:
                window.events.popleft()()

    def wait_key(self, milliseconds: int) -> int:
        """Wait at most that long for a key (0: forever). Returns its code, or -1 for none."""
        clock = self.session.clock
        end = None if milliseconds <= 0 else clock.steady() + milliseconds * 1_000_000
        while True:
            self._pressed.clear()
            self.deliver()
            if self.keys:
                break
            remaining = None if end is None else (end - clock.steady()) * 1e-9
            if remaining is not None and remaining <= 0:
                return -1
            self._pressed.wait(remaining)
        return self.keys.popleft()


def desk() -> Desk:
    """Return the current session's desk."""
    session = current()
    found = getattr(session, "_desk", None)
    if found is None:
        found = session._desk = Desk(session)  # type: ignore[attr-defined]
    return found  # type: ignore[no-any-return]


def as_bgr(image: Any) -> Any:
    """Convert an array to a window's image, as OpenCV does: 16-bit values are divided, floats range from 0 to 1."""
    if image.dtype == np.uint16:
        image = (image >> 8).astype(np.uint8)
    elif image.dtype.kind == "f":
        image = np.clip(image * 255.0, 0, 255).astype(np.uint8)
    elif image.dtype != np.uint8:
        image = image.astype(np.uint8)
    if image.ndim == 2 or image.shape[2] == 1:
        return cv2.cvtColor(image, cv2.COLOR_GRAY2BGR)
    return image if image.shape[2] == 3 else cv2.cvtColor(image, cv2.COLOR_BGRA2BGR)
