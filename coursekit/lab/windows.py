"""OpenCV's windows in the notebook: the images of `cv2.imshow`, live, and the keys for `cv2.waitKey`."""

from __future__ import annotations

from typing import Any

import ipywidgets

from coursekit.processes.process import current_process
from coursekit.processes.session import current
from coursekit.view import highgui
from coursekit.view.desk import Desk, Window, desk, unwatch, watch

from .bundle import with_text
from .errors import NotThere
from .picture import Picture

NO_WINDOWS = "No windows are open. cv2.imshow('name', image) opens one."


class WindowPicture(Picture):
    """One window with its trackbars; after a click on it, `cv2.waitKey` returns the pressed keys."""

    def __init__(self, desk: Desk, window: Window) -> None:
        super().__init__(lambda: None if window.image is None else highgui.as_bgr(window.image))
        self.window = window
        self.on_key = desk.press

    def heading(self) -> str:
        """Return the window's title."""
        return f"{self.window.title}"

    def note(self) -> str:
        """Return the image size."""
        image = self.window.image
        return "" if image is None else f"{image.shape[1]}x{image.shape[0]}"

    def is_open(self) -> bool:
        """Whether the window is still open."""
        return self.window.open

    def controls(self) -> dict[str, Any]:
        """Return the window's trackbars, and whether a program hears of the mouse."""
        bars = self.window.trackbars.items()
        shown = [{"name": name, "value": bar.value, "min": bar.least, "max": bar.most} for name, bar in bars]
        return {"trackbars": shown, "mouse": self.window.on_mouse is not None}

    def touched(self, message: dict[str, Any]) -> None:
        """Move a trackbar, or use the mouse."""
        if message["type"] == "slide" and message["name"] in self.window.trackbars:
            self.window.slide(message["name"], int(message["value"]))
        elif message["type"] == "mouse":
            self.window.mouse(*(int(message[part]) for part in ("event", "x", "y", "flags")))

    def __repr__(self) -> str:
        return repr(self.window)


class Windows:
    """All windows of the session, or the named ones, side by side; new windows appear automatically."""

    def __init__(self, names: tuple[str, ...]) -> None:
        self.names = names
        self.desk = desk()
        self._pictures: dict[Window, WindowPicture] = {}
        self._box: Any = None
        for window in self.desk.windows.values():
            self._take(window)
        watch(self._hear)

    def press(self, key: str | int) -> None:
        """Press a key, as if one of the windows had the focus: `cv2.waitKey` returns it."""
        self.desk.press(key)

    def __getitem__(self, name: str) -> Window:
        """Return the window of that name: `.image` is its image; LookupError if it is not open."""
        try:
            return self.desk.windows[name]
        except KeyError:
            known = ", ".join(self.desk.windows) or "none"
            raise NotThere(f"There is no window '{name}'. Open are: {known}") from None

    def _take(self, window: Window) -> WindowPicture | None:
        if self.names and window.name not in self.names:
            return None
        if window not in self._pictures:
            self._pictures[window] = WindowPicture(self.desk, window)
        return self._pictures[window]

    def _hear(self, window: Window) -> None:
        if window is not self.desk.windows.get(window.name) and window not in self._pictures:
            return
        known = window in self._pictures
        picture = self._take(window)
        if picture is None:
            return
        if not window.open:
            del self._pictures[window]
        if self._box is not None and (not known or not window.open) and not self.desk.session.clock.virtual:
            self._box.children = tuple(self._pictures.values())
        picture.news()

    def __repr__(self) -> str:
        shown = [repr(window) for window in self._pictures if window.open]
        return "\n".join(shown) or NO_WINDOWS

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        layout = ipywidgets.Layout(display="flex", flex_flow="row wrap", grid_gap="10px")
        self._box = ipywidgets.Box(tuple(self._pictures.values()), layout=layout)
        return with_text(self._box._repr_mimebundle_(**kwargs), repr(self))


_shown: dict[tuple[str, ...], Windows] = {}


def windows(*names: str) -> Windows:
    """Show the present and future windows of `cv2.imshow` as live pictures; with names, only those.

    Click a window and press a key for `cv2.waitKey`; from code: `windows().press("q")`. Trackbars are sliders below the
    picture; from code: `windows()["tune"].slide("hue", 20)`, and for the mouse `windows()["frame"].click(320, 240)`.

    >>> %ros2 run image_tools cam2image --ros-args -p burger_mode:=true &
    [cam2image: running]
    >>> %ros2 run image_tools showimage &
    [showimage: running]
    >>> wait(2)
    >>> windows()
    [window /image: 320x240]
    """
    older = _shown.pop(names, None)
    if older is not None:
        unwatch(older._hear)
    _shown[names] = Windows(names)
    return _shown[names]


def show_new_windows() -> None:
    """Show a window that a cell itself opens with `cv2.imshow` below that cell."""
    watch(_appear)


def _appear(window: Window) -> None:
    if window.shown > 1 or not window.open or current_process() is not None or not current().in_cell:
        return
    from IPython.display import display

    everything, own = _shown.get(()), _shown.get((window.name,))
    if own is not None and window in own._pictures:
        return
    if (window.image is not None or window.trackbars) and (everything is None or everything._box is None):
        display(windows(window.name))
