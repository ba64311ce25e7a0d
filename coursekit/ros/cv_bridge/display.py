"""Depths, labels and colours as an image that people look at."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np

from cv_bridge.core import CvBridgeError, converted, parsed_encoding

_MIDDLE_GREY = 128
_BACKGROUND = -1  # the label of what belongs to nothing
_DEGREES_BETWEEN_LABELS = 137  # no divisor of the circle: 360 labels have a hue each, and neighbours differ much


def cvtColorForDisplay(
    source: Any,
    encoding_in: str,
    encoding_out: str = "",
    do_dynamic_scaling: bool = False,
    min_image_value: float = 0.0,
    max_image_value: float = 0.0,
    colormap: int = -1,
) -> Any:
    """A copy of `source` for people to look at, in bgr8 or another encoding of 8 bits.

    The numbers of one channel become shades, or colours of OpenCV's `colormap`: between the two limits, or the image's
    own with `do_dynamic_scaling`. Labels (32SC1 to bgr8) have a colour each, -1 is black. Without limits only what has
    colours, and 16UC1, can be shown. Raises CvBridgeError.

    >>> import numpy
    >>> cvtColorForDisplay(numpy.array([[0.5, 1.0, 2.5]]), "64FC1", "mono8", max_image_value=2.0)
    array([[ 64, 128, 255]], dtype=uint8)
    """
    wanted = _encoding_to_show(encoding_in, encoding_out)
    image = np.asarray(source)
    if encoding_in == "32SC1" and wanted == "bgr8":
        return _colours_of_labels(image)
    limits = (min_image_value, max_image_value)
    if do_dynamic_scaling or limits[0] != limits[1]:
        _check_can_be_scaled(encoding_in)
    if do_dynamic_scaling:
        finite = np.isfinite(image).astype(np.uint8)
        limits = cv2.minMaxLoc(np.asarray(image, parsed_encoding(encoding_in).dtype), finite)[:2]
        if limits[0] == limits[1]:
            return converted(np.full(image.shape, _MIDDLE_GREY, np.uint8), "mono8", wanted)
    if limits[0] != limits[1]:
        return _scaled(image, encoding_in, wanted, limits, colormap)
    return converted(source, "mono16" if encoding_in == "16UC1" else encoding_in, wanted)


def _encoding_to_show(source: str, wanted: str) -> str:
    encoding = parsed_encoding(wanted or source)
    if wanted:
        if encoding.kind in ("mono", "bgr", "rgb", "bgra", "rgba") and encoding.bits == 8:
            return wanted
        raise CvBridgeError(f"cvtColorForDisplay has no images of [{wanted}]: ask for bgr8, rgb8 or mono8")
    if encoding.bits > 16 and (encoding.bits > 32 or encoding.channels > 1):
        raise CvBridgeError(f"cvtColorForDisplay chooses no encoding for [{source}]: name one, for example bgr8")
    return "bgr8"


def _check_can_be_scaled(encoding: str) -> None:
    if parsed_encoding(encoding).channels != 1:
        raise CvBridgeError(f"cvtColorForDisplay scales images of one channel only, not of [{encoding}]")


def _colours_of_labels(labels: Any) -> Any:
    """Blue, green and red of each label: hues round the circle."""
    hues = labels.astype(np.int64) * _DEGREES_BETWEEN_LABELS % 360
    colours = [np.clip(np.abs((hues + turn) % 360 - 180) - 60, 0, 60) * 255 // 60 for turn in (120, 240, 0)]
    made = np.stack(colours, axis=-1).astype(np.uint8)
    made[labels == _BACKGROUND] = 0
    return made


def _scaled(image: Any, encoding: str, wanted: str, limits: tuple[float, float], colormap: int) -> Any:
    shades = _shades(image, parsed_encoding(encoding).dtype, *limits)
    if colormap == -1:
        return converted(shades, "mono8", wanted)
    colours = cv2.applyColorMap(shades, colormap)
    if encoding == "32FC1":
        colours[np.isnan(image)] = 0
    return converted(colours, "bgr8", wanted)


def _shades(image: Any, dtype: str, low: float, high: float) -> Any:
    """0 to 255 for `low` to `high`; what is not finite is black, as OpenCV's rounding makes it on a PC.

    OpenCV takes the low limit off in the image's own type, and scales in single precision.
    """
    if np.dtype(dtype).kind in "iu":
        above = np.clip(np.rint(image.astype(np.float64) - low), np.iinfo(dtype).min, np.iinfo(dtype).max)
    else:
        above = image.astype(dtype) - np.dtype(dtype).type(low)
    finite = np.where(np.isfinite(above), above, 0.0).astype(np.float32)
    return np.clip(np.rint(finite * np.float32(255.0 / (high - low))), 0, 255).astype(np.uint8)
