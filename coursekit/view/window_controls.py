"""OpenCV's functions for trackbars and the mouse in a session's windows (`coursekit.view.desk`)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import cv2

from coursekit.processes.current_process import current_process

from .desk import Trackbar, Window, desk, tell


def existing(name: str) -> Window:
    """Return an open window; cv2.error, with what to do, if there is none of that name."""
    if name not in desk().windows:
        known = ", ".join(desk().windows) or "none"
        raise cv2.error(f"There is no window '{name}'. There are: {known}. Make it: cv2.namedWindow('{name}')")
    return desk().windows[name]


def _bar(name: str, window: str) -> Trackbar | None:
    shown = desk().windows.get(window)
    return None if shown is None else shown.trackbars.get(name)


def createTrackbar(
    trackbarName: str, windowName: str, value: int, count: int, onChange: Callable[[int], Any] | None = None
) -> None:
    """Add a slider from 0 to `count` to a window; `onChange(value)` is called while the program waits for keys."""
    window = existing(windowName)
    window.trackbars[trackbarName] = Trackbar(value, int(count), onChange)
    tell(window)


def getTrackbarPos(trackbarname: str, winname: str) -> int:
    """Return a trackbar's value, or -1 if there is none of that name."""
    bar = _bar(trackbarname, winname)
    return -1 if bar is None else bar.value


def setTrackbarPos(trackbarname: str, winname: str, pos: int) -> None:
    """Move a trackbar; a new value is told to the program at once."""
    bar = _bar(trackbarname, winname)
    if bar is not None and bar.within(pos) != bar.value:
        bar.value = bar.within(pos)
        tell(existing(winname))
        bar.changed(bar.value)


def setTrackbarMin(trackbarname: str, winname: str, minval: int) -> None:
    """Change the lower end of a trackbar."""
    bar = _bar(trackbarname, winname)
    if bar is not None:
        bar.least = int(minval)
        setTrackbarPos(trackbarname, winname, bar.value)
        tell(existing(winname))


def setTrackbarMax(trackbarname: str, winname: str, maxval: int) -> None:
    """Change the upper end of a trackbar."""
    bar = _bar(trackbarname, winname)
    if bar is not None:
        bar.most = int(maxval)
        setTrackbarPos(trackbarname, winname, bar.value)
        tell(existing(winname))


def setMouseCallback(windowName: str, onMouse: Callable[..., Any] | None, param: Any = None) -> None:
    """Call `onMouse(event, x, y, flags, param)` for what the mouse does in a window, while the program waits for keys."""
    window = existing(windowName)
    window.owner = current_process()
    window.on_mouse = None if onMouse is None else lambda *given: onMouse(*given, param)
    tell(window)


def setWindowProperty(winname: str, prop_id: int, prop_value: float) -> None:
    """Do nothing: the notebook decides how large its windows are, and in which order."""


def getWindowImageRect(winname: str) -> tuple[int, int, int, int]:
    """Return the place and size of a window's image."""
    image = existing(winname).image
    return (0, 0, 0, 0) if image is None else (0, 0, image.shape[1], image.shape[0])


def startWindowThread() -> int:
    """Return 0: no thread is needed."""
    return 0


CONTROLS = (
    createTrackbar,
    getTrackbarPos,
    setTrackbarPos,
    setTrackbarMin,
    setTrackbarMax,
    setMouseCallback,
    setWindowProperty,
    getWindowImageRect,
    startWindowThread,
)
