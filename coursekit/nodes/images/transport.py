"""The two transports: raw (sensor_msgs/Image) and compressed (sensor_msgs/CompressedImage on `<topic>/compressed`)."""

from __future__ import annotations

from typing import Any

import cv2
from cv_bridge import CvBridge, CvBridgeError
from cv_bridge.encodings import parse
from sensor_msgs.msg import CompressedImage, Image

TRANSPORTS: dict[str, Any] = {"raw": Image, "compressed": CompressedImage}
JPEG_QUALITY, PNG_LEVEL = 95, 3
_bridge = CvBridge()


def topic_of(base: str, transport: str) -> str:
    """Return the topic a transport uses for an image topic. ValueError for an unknown transport.

    >>> topic_of("/camera/image_raw", "compressed")
    '/camera/image_raw/compressed'
    """
    if transport not in TRANSPORTS:
        raise ValueError(f"There is no transport '{transport}'. There are: {', '.join(TRANSPORTS)}.")
    return base if transport == "raw" else f"{base}/{transport}"


def compress(
    msg: Image, format_: str = "jpeg", jpeg_quality: int = JPEG_QUALITY, png_level: int = PNG_LEVEL
) -> CompressedImage:
    """Compress a raw image as JPEG or PNG. Raises CvBridgeError for encodings that cannot be compressed.

    >>> import numpy as np
    >>> small = compress(_bridge.cv2_to_imgmsg(np.zeros((48, 64, 3), np.uint8), "bgr8"))
    >>> small.format, len(small.data) < 48 * 64 * 3
    ('bgr8; jpeg compressed bgr8', True)
    """
    encoding = parse(msg.encoding)
    colour = encoding.channels > 1 or encoding.kind.startswith("bayer")
    if not encoding.kind or format_ not in ("jpeg", "png"):
        raise CvBridgeError(f"[{msg.encoding}] cannot be compressed as {format_}; use a colour or mono encoding.")
    deep = format_ == "png" and encoding.bits == 16
    target = f"{'bgr' if colour else 'mono'}{16 if deep else 8}"
    image = _bridge.imgmsg_to_cv2(msg, target)
    option = (cv2.IMWRITE_JPEG_QUALITY, jpeg_quality) if format_ == "jpeg" else (cv2.IMWRITE_PNG_COMPRESSION, png_level)
    data = cv2.imencode(f".{format_}", image, option)[1].tobytes()
    text = f"{msg.encoding}; {format_} compressed {target if colour else ''}"
    return CompressedImage(header=msg.header, format=text, data=data)


def decompress(msg: CompressedImage) -> Image:
    """Decompress an image to its original encoding. Raises CvBridgeError."""
    image = _bridge.compressed_imgmsg_to_cv2(msg)
    bits = image.dtype.itemsize * 8
    stored = f"mono{bits}" if image.ndim == 2 else f"{'bgra' if image.shape[2] == 4 else 'bgr'}{bits}"
    raw = _bridge.cv2_to_imgmsg(image, stored, header=msg.header)
    wanted, semicolon, _ = msg.format.partition(";")
    if not semicolon or wanted == stored or wanted.startswith(("bayer", "yuv", "uyvy")):
        return raw
    return _bridge.cv2_to_imgmsg(_bridge.imgmsg_to_cv2(raw, wanted), wanted, header=msg.header)


def to_bgr(msg: Any) -> Any:
    """Convert a raw or compressed message to an image OpenCV can show; non-colour values are scaled to grey."""
    if isinstance(msg, CompressedImage):
        image = _bridge.compressed_imgmsg_to_cv2(msg)
        return image if image.ndim == 3 else cv2.cvtColor(image, cv2.COLOR_GRAY2BGR)
    encoding = parse(msg.encoding)
    if encoding.kind:
        return _bridge.imgmsg_to_cv2(msg, "bgr8")
    image = _bridge.imgmsg_to_cv2(msg)
    if encoding.cv_type == "8UC3":
        return image
    first = image if image.ndim == 2 else image[:, :, 0]
    low, high = float(first.min()), float(first.max())
    grey = ((first - low) * (255.0 / ((high - low) or 1.0))).astype("uint8")
    return cv2.cvtColor(grey, cv2.COLOR_GRAY2BGR)
