"""The windows of a session that OpenCV's functions open: their images, trackbars, keys and mouse."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Any

import cv2

from coursekit.processes.current_process import current_process
from coursekit.processes.live_things import LiveThings
from coursekit.processes.session import current

_UP = cv2.EVENT_LBUTTONUP - cv2.EVENT_LBUTTONDOWN
_FLAGS = {
    cv2.EVENT_LBUTTONDOWN: cv2.EVENT_FLAG_LBUTTON,
    cv2.EVENT_RBUTTONDOWN: cv2.EVENT_FLAG_RBUTTON,
    cv2.EVENT_MBUTTONDOWN: cv2.EVENT_FLAG_MBUTTON,
}


class Trackbar:
    """A slider of a window: its value, its ends, and the program's function that is told of a new value."""

    def __init__(self, value: int, most: int, changed: Callable[[int], Any] | None) -> None:
        self.least, self.most = 0, most
        self.value = self.within(value)
        self.changed = changed or (lambda _: None)
        self.owner = current_process()

    def within(self, value: int) -> int:
        """Return the nearest value between the ends."""
        return max(self.least, min(self.most, int(value)))


class Window:
    """A named window with its newest image."""

    def __init__(self, name: str, desk: Desk) -> None:
        self.name = name
        self.title = name
        self.image: Any = None
        self.shown = 0
        """The number of images shown so far."""
        self.open = True
        self.trackbars: dict[str, Trackbar] = {}
        self.on_mouse: Callable[[int, int, int, int], Any] | None = None
        self.owner: Any = None
        """The program that hears of the mouse."""
        self._desk = desk

    def slide(self, trackbar: str, value: int) -> None:
        """Move a trackbar by hand; its program is told in its next waitKey."""
        bar = self.trackbars[trackbar]
        new = bar.within(value)
        if new != bar.value:
            bar.value = new
            self._desk.post(self, bar.owner, lambda: bar.changed(new))
            tell(self)

    def mouse(self, event: int, x: int, y: int, flags: int = 0) -> None:
        """Use the mouse at a pixel of the image: one of cv2's EVENT_..., and its EVENT_FLAG_...s."""
        heard = self.on_mouse
        if heard is not None:
            self._desk.post(self, self.owner, lambda: heard(event, x, y, flags))

    def click(self, x: int, y: int, event: int = cv2.EVENT_LBUTTONDOWN) -> None:
        """Press a button at a pixel, the left one by default, and release it."""
        for kind in (event, event + _UP):
            self.mouse(kind, x, y, _FLAGS[event])

    def __repr__(self) -> str:
        size = "no image yet" if self.image is None else f"{self.image.shape[1]}x{self.image.shape[0]}"
        values = "".join(f", {name} {bar.value}" for name, bar in self.trackbars.items())
        return f"[window {self.name}: {size}{values}]"


_windows = LiveThings[Window]("cv2")
watch = _windows.watch
unwatch = _windows.unwatch
tell = _windows.tell


class Desk:
    """The windows of one session, the keys pressed in them, and what programs have yet to be told."""

    def __init__(self, session: Any) -> None:
        self.session = session
        self.windows: dict[str, Window] = {}
        self.keys: deque[int] = deque(maxlen=100)
        self._posted: deque[tuple[Window, Any, Callable[[], Any]]] = deque()
        self._waiting: list[Any] = []
        """An event for each program that waits for keys: one that they shared could be cleared before all have seen it."""

    def window(self, name: str) -> Window:
        """Return the window of that name, opened on first use."""
        window = self.windows.get(name)
        if window is None:
            window = self.windows[name] = Window(name, self)
            tell(window)
        return window

    def close(self, name: str) -> None:
        """Close a window; does nothing if there is none."""
        window = self.windows.pop(name, None)
        if window is not None:
            window.open = False
            tell(window)

    def press(self, key: str | int) -> None:
        """Press a key: a character, or a key code as returned by waitKey."""
        self.keys.append(ord(key) if isinstance(key, str) else int(key))
        self._wake()

    def post(self, window: Window, owner: Any, call: Callable[[], Any]) -> None:
        """Have a program tell itself of something in its next waitKey, as OpenCV does."""
        self._posted.append((window, owner, call))
        self._wake()

    def wait_key(self, milliseconds: int) -> int:
        """Wait at most that long for a key (0: forever). Returns its code, or -1 for none."""
        clock = self.session.clock
        end = None if milliseconds <= 0 else clock.steady() + milliseconds * 1_000_000
        news = clock.new_event()
        self._waiting.append(news)
        try:
            while True:
                news.clear()
                self.serve()
                if self.keys:
                    return self.keys.popleft()
                remaining = None if end is None else (end - clock.steady()) * 1e-9
                if remaining is not None and remaining <= 0:
                    return -1
                news.wait(remaining)
        finally:
            self._waiting.remove(news)

    def _wake(self) -> None:
        for news in list(self._waiting):
            news.set()

    def serve(self) -> None:
        """Tell the calling program what was done in its windows."""
        mine = current_process()
        for posted in [event for event in self._posted if event[1] is mine]:
            self._posted.remove(posted)
            if posted[0].open:
                posted[2]()


def desk() -> Desk:
    """Return the current session's desk."""
    session = current()
    desk = getattr(session, "_desk", None)
    if desk is None:
        desk = session._desk = Desk(session)  # type: ignore[attr-defined]
    return desk  # type: ignore[no-any-return]
