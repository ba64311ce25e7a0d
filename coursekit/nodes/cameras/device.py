"""A camera device under the name that Linux gives it, read with OpenCV."""

from __future__ import annotations

import re
from typing import Any

import cv2


class NoDevice(OSError):
    """There is no such camera; the message says which there are."""


def opened(path: str) -> Any:
    """Open /dev/video0 and so on, or the camera's number. NoDevice where there is none.

    >>> opened("/dev/video42")
    Traceback (most recent call last):
    coursekit.nodes.cameras.device.NoDevice: /dev/video42
    """
    numbered = re.fullmatch(r"(?:/dev/video)?(\d+)", path)
    capture = cv2.VideoCapture(int(numbered[1]) if numbered else path)
    if not capture.isOpened():
        raise NoDevice(path)
    return capture


def resize(capture: Any, width: int, height: int) -> tuple[int, int]:
    """Ask for a size, and return the size that the camera has: its own where it cannot give that one."""
    capture.set(cv2.CAP_PROP_FRAME_WIDTH, width)
    capture.set(cv2.CAP_PROP_FRAME_HEIGHT, height)
    return round(capture.get(cv2.CAP_PROP_FRAME_WIDTH)), round(capture.get(cv2.CAP_PROP_FRAME_HEIGHT))
