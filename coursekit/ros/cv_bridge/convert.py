"""Conversions between encodings, by the rules of cv_bridge's C++ part."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np

from cv_bridge.encodings import Encoding, parse

_SUFFIX = {"mono": "GRAY", "bgr": "BGR", "rgb": "RGB", "bgra": "BGRA", "rgba": "RGBA"}
_BAYER = {"bayer_rggb": "BayerBG", "bayer_bggr": "BayerRG", "bayer_gbrg": "BayerGR", "bayer_grbg": "BayerGB"}
_YUV = {"uyvy": "UYVY", "yuyv": "YUY2"}


class ConversionError(ValueError):
    """The conversion makes no sense or is not implemented."""


def convert(image: Any, source: str, target: str) -> Any:
    """A copy of `image`, converted from the encoding `source` to `target`; raises ConversionError."""
    before, after = parse(source), parse(target)
    if source == target:
        return image.copy()
    code = _colour_code(before, after)
    if code is not None:
        image = cv2.cvtColor(image, code)
    return _to_depth(image, before, after)


def _colour_code(before: Encoding, after: Encoding) -> int | None:
    """OpenCV's code of the conversion; None if the order of colours stays the same."""
    if not before.kind and after.kind:
        raise ConversionError(
            f"[{before.name}] is not a color format. but [{after.name}] is. The conversion does not make sense"
        )
    if not (before.kind and after.kind):
        _check_channels(before, after)
        return None
    if before.kind == after.kind:
        return None
    name = _conversion_name(before.kind, after.kind)
    code = getattr(cv2, name, None) if name else None
    if code is None:
        raise ConversionError(f"Unsupported conversion from [{before.name}] to [{after.name}]")
    return int(code)


def _check_channels(before: Encoding, after: Encoding) -> None:
    if before.channels == after.channels:
        return
    if before.kind:
        raise ConversionError(
            f"[{before.name}] is a color format but [{after.name}] is not so they must have the same OpenCV "
            "type, CV_8UC3, CV16UC1 ...."
        )
    raise ConversionError(f"[{before.name}] and [{after.name}] do not have the same number of channel")


def _conversion_name(before: str, after: str) -> str | None:
    if after not in _SUFFIX:
        return None
    if before in _SUFFIX:
        return f"COLOR_{_SUFFIX[before]}2{_SUFFIX[after]}"
    if before in _YUV:
        return f"COLOR_YUV2{_SUFFIX[after]}_{_YUV[before]}"
    return None if after in ("bgra", "rgba") else f"COLOR_{_BAYER[before]}2{_SUFFIX[after]}"


def _to_depth(image: Any, before: Encoding, after: Encoding) -> Any:
    """The same image with another depth. Values are scaled between 8 and 16 bits; integers are rounded and clipped."""
    if image.dtype == after.dtype:
        return image if image.flags.owndata else image.copy()
    if (before.bits, after.bits) == (8, 16):
        image = image * (65535.0 / 255.0)
    elif (before.bits, after.bits) == (16, 8):
        image = image * (255.0 / 65535.0)
    if after.depth.endswith("F"):
        return image.astype(after.dtype)
    limits = np.iinfo(after.dtype)
    return np.clip(np.rint(image), limits.min, limits.max).astype(after.dtype)
