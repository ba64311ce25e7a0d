"""Types and colours of images, under the names of cv_bridge's C++ part."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np

from cv_bridge.core import CvBridge, converted, parsed_encoding

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


def cvtColorForDisplay(
    source: Any,
    encoding_in: str,
    encoding_out: str = "",
    do_dynamic_scaling: bool = False,
    min_image_value: float = 0.0,
    max_image_value: float = 0.0,
    colormap: int = -1,
) -> Any:
    """A copy of `source` for people to look at: depths and labels become shades, or `colormap`'s colours.

    Without `min_image_value` and `max_image_value`, or with `do_dynamic_scaling`, the image's own limits are black and
    white. Raises CvBridgeError.
    """
    encoding, wanted = parsed_encoding(encoding_in), encoding_out or "bgr8"
    if encoding.cv_type == "8UC3" and not encoding.kind:
        return converted(source, "bgr8", wanted)
    if encoding.channels != 1 or (encoding.kind and encoding.bits == 8):
        return converted(source, encoding_in, wanted)
    limits = (min_image_value, max_image_value)
    if do_dynamic_scaling or min_image_value == max_image_value:
        limits = cv2.minMaxLoc(np.asarray(source, np.float64))[:2]
    shades = _shades(source, *limits)
    if colormap >= 0:
        return converted(cv2.applyColorMap(shades, colormap), "bgr8", wanted)
    return converted(shades, "mono8", wanted)


def _shades(image: Any, low: float, high: float) -> Any:
    """Values from `low` to `high` as 0 to 255; what is no number is black."""
    scale = 255.0 / (high - low) if high > low else 1.0
    scaled = (np.asarray(image, np.float64) - (low if high > low else 0.0)) * scale
    return np.clip(np.rint(np.nan_to_num(scaled, nan=0.0)), 0, 255).astype(np.uint8)
