"""OpenCV's windows and camera in a session: `cv2.imshow`, `waitKey`, `VideoCapture(0)` and related functions.

The OpenCV wheel of the course opens no windows, and most lab machines have no webcam. When cv2 is imported in a
session, `install` adds

- imshow, namedWindow, waitKey, waitKeyEx, pollKey, destroyWindow, destroyAllWindows, getWindowProperty,
  setWindowTitle, resizeWindow, moveWindow, selectROI, trackbars and the mouse (`window_controls`): windows are kept here,
  and a notebook shows them (`coursekit.lab.windows()`);
- VideoCapture: camera 0, also called /dev/video0, is the virtual one; files and URLs are opened by OpenCV itself;
- names of Humble's OpenCV that a newer one lacks (`older_opencv`).

It does not replace working functions: windows stay OpenCV's own where it can open them (a display, and a build with a
GUI), and the real camera stays where there is a device (`/dev/video0`). COURSEKIT_CAMERA=virtual or real overrides
the camera's choice.
"""

from __future__ import annotations

import os
import re
import sys
from typing import Any

import cv2
import numpy as np

from coursekit.processes.patching import IMPORTS, Patch, always, patch_manager

from . import older_opencv
from .capture import VirtualCapture
from .desk import desk, tell
from .region_selection import selectROI, selectROIs
from .window_controls import CONTROLS, existing

_RealCapture = cv2.VideoCapture


def as_bgr(image: Any) -> Any:
    """Convert an array to a window's image, as OpenCV does: 16-bit values are divided, floats range from 0 to 1.

    >>> as_bgr(np.array([[0.0, 1.0]])).tolist()
    [[[0, 0, 0], [255, 255, 255]]]
    """
    if image.dtype == np.uint16:
        image = (image >> 8).astype(np.uint8)
    elif image.dtype.kind == "f":
        image = np.clip(image * 255.0, 0, 255).astype(np.uint8)
    elif image.dtype != np.uint8:
        image = image.astype(np.uint8)
    if image.ndim == 2 or image.shape[2] == 1:
        return cv2.cvtColor(image, cv2.COLOR_GRAY2BGR)
    return image if image.shape[2] == 3 else cv2.cvtColor(image, cv2.COLOR_BGRA2BGR)


# -- OpenCV's functions


def imshow(winname: str, mat: Any) -> None:
    """Show an image in a window, which is opened if necessary."""
    if not isinstance(mat, np.ndarray) or not mat.size or mat.ndim not in (2, 3):
        raise cv2.error(
            f"imshow('{winname}') got no image but {type(mat).__name__}. If it comes from a camera or a file, look at "
            "what read() or imread() returned first: they give None when there is nothing to read."
        )
    window = desk().window(winname)
    window.image = mat.copy()
    window.shown += 1
    tell(window)


def namedWindow(winname: str, flags: int = 1) -> None:
    """Open a window."""
    desk().window(winname)


def destroyWindow(winname: str) -> None:
    """Close a window; cv2.error if there is none of that name."""
    desk().close(existing(winname).name)


def destroyAllWindows() -> None:
    """Close all windows."""
    for name in list(desk().windows):
        desk().close(name)


def waitKey(delay: int = 0) -> int:
    """Wait `delay` ms of session time for a key (0: forever). Returns its code, or -1 for none."""
    return desk().wait_key(int(delay))


def pollKey() -> int:
    """Return the pressed key, or -1 for none, without waiting."""
    desk().serve()
    return desk().keys.popleft() if desk().keys else -1


def setWindowTitle(winname: str, title: str) -> None:
    """Change a window's title."""
    window = desk().window(winname)
    window.title = title
    tell(window)


def getWindowProperty(winname: str, prop_id: int) -> float:
    """Return 1.0 for an open window, otherwise -1.0."""
    return 1.0 if winname in desk().windows else -1.0


def resizeWindow(winname: str, *_size: Any) -> None:
    """Do nothing: a window in a notebook is as wide as its image, or as the page."""


def moveWindow(winname: str, x: int, y: int) -> None:
    """Do nothing: the notebook positions the windows."""


class VideoCapture:
    """`cv2.VideoCapture`: the virtual camera for a number or device, OpenCV's own reader for a file or URL."""

    def __new__(cls, *args: Any, **kwargs: Any) -> Any:
        index = args[0] if args else kwargs.get("index", kwargs.get("filename"))
        if isinstance(index, str) and (device := re.fullmatch(r"/dev/video(\d+)", index)):
            index = int(device[1])
        if index is None or isinstance(index, (int, np.integer)):
            return VirtualCapture(-1 if index is None else int(index))
        return _RealCapture(*args, **kwargs)


_WINDOWS = (
    imshow,
    namedWindow,
    destroyWindow,
    destroyAllWindows,
    waitKey,
    pollKey,
    setWindowTitle,
    getWindowProperty,
    resizeWindow,
    moveWindow,
    selectROI,
    selectROIs,
    *CONTROLS,
)


def has_display() -> bool:
    """Whether OpenCV itself can open windows here."""
    gui = next((line for line in cv2.getBuildInformation().splitlines() if line.strip().startswith("GUI:")), "")
    if "NONE" in gui or not gui:
        return False
    return sys.platform in ("win32", "darwin") or bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def has_camera() -> bool:
    """Whether to use a real camera."""
    wish = os.environ.get("COURSEKIT_CAMERA", "")
    return os.path.exists("/dev/video0") if wish not in ("virtual", "real") else wish == "real"


def install() -> None:
    """Patch cv2 with the functions missing here, while sessions are open."""
    if not has_display():
        patch_manager.lend(*_WINDOW_PATCHES)
    if not has_camera():
        patch_manager.lend(_CAMERA_PATCH)
    patch_manager.lend(*older_opencv.PATCHES, at_once=True)


def patches() -> list[Patch]:
    """Return all possible patches, regardless of this computer."""
    return [*_WINDOW_PATCHES, _CAMERA_PATCH, *older_opencv.PATCHES]


_TEST = "tests/view/test_highgui.py"
_WINDOW_PATCHES = [
    Patch(f"cv2.{name}", always(function), "windows of a program are shown by the session", _TEST, IMPORTS)
    for name, function in [*((function.__name__, function) for function in _WINDOWS), ("waitKeyEx", waitKey)]
]
_CAMERA_PATCH = Patch(
    "cv2.VideoCapture", always(VideoCapture), "where there is no camera one is simulated", _TEST, IMPORTS
)
