"""OpenCV's selectROI and selectROIs in a session's windows: a rectangle that is drawn with the mouse."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np

_NAME = "ROI selector"
_SPACE, _ENTER, _ESCAPE, _CANCEL = 32, 13, 27, ord("c")
_BLUE = (255, 0, 0)
Box = tuple[int, int, int, int]


class _Drag:
    """The rectangle that is being drawn in an image."""

    def __init__(self, image: Any, from_center: bool) -> None:
        self._height, self._width = image.shape[:2]
        self._from_center, self._pressed = from_center, False
        self._start = self._end = (0, 0)

    def mouse(self, event: int, x: int, y: int, _flags: int = 0, _param: Any = None) -> None:
        """Take what the mouse does: press, move, release."""
        if event == cv2.EVENT_LBUTTONDOWN:
            self._start, self._pressed = (x, y), True
        if self._pressed:
            self._end = (x, y)
        if event == cv2.EVENT_LBUTTONUP:
            self._pressed = False

    @property
    def box(self) -> Box:
        """Left, top, width and height, within the image; zeros for none."""
        (x, y), (u, v) = self._start, self._end
        if self._from_center:
            x, y = 2 * x - u, 2 * y - v
        left, right = (min(max(side, 0), self._width) for side in sorted((x, u)))
        top, bottom = (min(max(side, 0), self._height) for side in sorted((y, v)))
        return (left, top, right - left, bottom - top) if right > left and bottom > top else (0, 0, 0, 0)

    def drawn(self, image: Any, crosshair: bool) -> Any:
        """The image with the rectangle."""
        picture, (x, y, width, height) = image.copy(), self.box
        if width:
            cv2.rectangle(picture, (x, y), (x + width, y + height), _BLUE, 2)
            if crosshair:
                cv2.line(picture, (x, y + height // 2), (x + width, y + height // 2), _BLUE, 2)
                cv2.line(picture, (x + width // 2, y), (x + width // 2, y + height), _BLUE, 2)
        return picture


def _choose(name: str, image: Any, crosshair: bool, from_center: bool) -> tuple[Box, int]:
    """Let the user draw until a key ends it; the rectangle and the key."""
    drag, key = _Drag(image, from_center), -1
    cv2.imshow(name, image)
    cv2.setMouseCallback(name, drag.mouse)
    while key not in (_SPACE, _ENTER, _ESCAPE, _CANCEL):
        cv2.imshow(name, drag.drawn(image, crosshair))
        key = cv2.waitKey(30)
    cv2.setMouseCallback(name, lambda *_: None)
    return ((0, 0, 0, 0) if key == _CANCEL else drag.box), key


def _told(given: tuple[Any, ...]) -> tuple[str, list[Any]]:
    """The window's name and the rest, as both of OpenCV's forms have them: (name, image, ...) and (image, ...)."""
    return (str(given[0]), list(given[1:])) if isinstance(given[0], str) else (_NAME, list(given))


def selectROI(*given: Any, **named: Any) -> Box:
    """Let the user draw a rectangle, and take it with space or Enter, or cancel with c.

    selectROI([windowName, ]img, showCrosshair=True, fromCenter=False, printNotice=True) returns left, top, width and
    height [pixels], zeros without a rectangle.
    """
    name, image, crosshair, from_center, notice = _arguments(given, named)
    if notice:
        print("Select a ROI and then press SPACE or ENTER button!")
        print("Cancel the selection process by pressing c button!")
    return _choose(name, image, crosshair, from_center)[0]


def selectROIs(*given: Any, **named: Any) -> Any:
    """Let the user draw rectangles, take each with space or Enter, and end with Escape; (n, 4), or () for none.

    selectROIs(windowName, img, showCrosshair=True, fromCenter=False, printNotice=True).
    """
    name, image, crosshair, from_center, notice = _arguments(given, named)
    if notice:
        print("Finish the selection process by pressing ESC button!")
    boxes: list[Box] = []
    while True:
        box, key = _choose(name, image, crosshair, from_center)
        if key == _ESCAPE:
            return np.array(boxes, np.int32) if boxes else ()
        if box[2]:
            boxes.append(box)


def _arguments(given: tuple[Any, ...], named: dict[str, Any]) -> tuple[str, Any, bool, bool, bool]:
    if not given:
        given = tuple(named.pop(name) for name in ("windowName", "img") if name in named)
    name, rest = _told(given)
    if not rest and "img" in named:
        rest = [named.pop("img")]
    if not rest or not isinstance(rest[0], np.ndarray):
        raise cv2.error(
            f"selectROI needs an image, not {type(rest[0]).__name__ if rest else 'nothing'}: what did read() return?"
        )
    options = {"showCrosshair": True, "fromCenter": False, "printNotice": True}
    options |= dict(zip(options, rest[1:], strict=False)) | named
    return name, rest[0], bool(options["showCrosshair"]), bool(options["fromCenter"]), bool(options["printNotice"])
