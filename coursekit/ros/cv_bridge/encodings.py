"""Image encodings: depth, channels, order of colours. In ROS 2: sensor_msgs/image_encodings.hpp."""

from __future__ import annotations

import re
from dataclasses import dataclass

DTYPES = {
    "8U": "uint8",
    "8S": "int8",
    "16U": "uint16",
    "16S": "int16",
    "32S": "int32",
    "32F": "float32",
    "64F": "float64",
}
_COLOURS = {"mono": 1, "bgr": 3, "rgb": 3, "bgra": 4, "rgba": 4}
_BAYER = ("bayer_rggb", "bayer_bggr", "bayer_gbrg", "bayer_grbg")
_YUV = {"yuv422": "uyvy", "uyvy": "uyvy", "yuv422_yuy2": "yuyv", "yuyv": "yuyv"}
_PLAIN = re.compile(r"(8U|8S|16U|16S|32S|32F|64F)(?:C([0-9]+))?")


class UnknownEncoding(ValueError):
    """There is no encoding with that name."""


@dataclass(frozen=True)
class Encoding:
    """The type of one pixel: `kind` is its order of colours ('bgr', 'bayer_rggb', ...), '' for plain numbers."""

    name: str
    depth: str
    channels: int
    kind: str = ""

    @property
    def dtype(self) -> str:
        """numpy's name of the element type."""
        return DTYPES[self.depth]

    @property
    def bits(self) -> int:
        """Bits per element."""
        return int(self.depth[:-1])

    @property
    def cv_type(self) -> str:
        """OpenCV's name, for example '8UC3'."""
        return f"{self.depth}C{self.channels}"


def _named() -> dict[str, Encoding]:
    named = {}
    for bits in (8, 16):
        depth = f"{bits}U"
        for kind, channels in _COLOURS.items():
            named[f"{kind}{bits}"] = Encoding(f"{kind}{bits}", depth, channels, kind)
        for kind in _BAYER:
            named[f"{kind}{bits}"] = Encoding(f"{kind}{bits}", depth, 1, kind)
    for name, kind in _YUV.items():
        named[name] = Encoding(name, "8U", 2, kind)
    return named


NAMED = _named()


def parse(name: str) -> Encoding:
    """The encoding with that name; raises UnknownEncoding.

    >>> parse("bgr8").cv_type, parse("32FC1").dtype, parse("16U").channels
    ('8UC3', 'float32', 1)
    """
    if name in NAMED:
        return NAMED[name]
    match = _PLAIN.fullmatch(name)
    if match is None:
        known = ", ".join(NAMED)
        raise UnknownEncoding(f"Unrecognized image encoding [{name}]. Known are {known}, and 8UC1 to 64FC4.")
    return Encoding(name, match[1], int(match[2] or 1))
