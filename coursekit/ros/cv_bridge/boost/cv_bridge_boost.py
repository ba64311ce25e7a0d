"""Types and colours of images, under the names of cv_bridge's C++ part."""

from __future__ import annotations

from typing import Any

from cv_bridge.core import CvBridge, converted
from cv_bridge.display import cvtColorForDisplay

__all__ = ["CV_MAT_CNWrap", "CV_MAT_DEPTHWrap", "cvtColor2", "cvtColorForDisplay", "getCvType"]

_CHANNEL_SHIFT, _DEPTH_MASK = 3, 7  # how OpenCV packs both into one number


def getCvType(encoding: str) -> int:
    """OpenCV's number of an encoding's type; raises CvBridgeError for an unknown encoding.

    >>> getCvType("bgr8"), CV_MAT_CNWrap(getCvType("32FC2"))
    (16, 2)
    """
    return CvBridge().encoding_to_cvtype2(encoding)


def CV_MAT_CNWrap(cv_type: int) -> int:
    """The channels of OpenCV's number of a type."""
    return (cv_type >> _CHANNEL_SHIFT) + 1


def CV_MAT_DEPTHWrap(cv_type: int) -> int:
    """The depth of OpenCV's number of a type, for example `cv2.CV_32F`."""
    return cv_type & _DEPTH_MASK


def cvtColor2(image: Any, encoding_in: str, encoding_out: str) -> Any:
    """A copy of `image` in another encoding; raises CvBridgeError."""
    return converted(image, encoding_in, encoding_out)
