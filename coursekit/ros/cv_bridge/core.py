"""CvBridge: conversion of images between OpenCV and ROS messages."""

from __future__ import annotations

import array
import sys
from typing import Any

import cv2
import numpy as np
from sensor_msgs.msg import CompressedImage, Image

from cv_bridge.convert import ConversionError, convert
from cv_bridge.encodings import DTYPES, Encoding, UnknownEncoding, parse


class CvBridgeError(TypeError):
    """The conversion is not possible."""


class CvBridge:
    """Converts between OpenCV's arrays and ROS's image messages.

    >>> import numpy
    >>> bridge = CvBridge()
    >>> msg = bridge.cv2_to_imgmsg(numpy.zeros((480, 640, 3), numpy.uint8), encoding="bgr8")
    >>> (msg.width, msg.height, msg.encoding, msg.step, len(msg.data))
    (640, 480, 'bgr8', 1920, 921600)
    >>> bridge.imgmsg_to_cv2(msg, desired_encoding="mono8").shape
    (480, 640)
    """

    def __init__(self) -> None:
        names = [f"{depth}C{channels}" for depth in DTYPES for channels in (1, 2, 3, 4)]
        self.cvtype_to_name = {getattr(cv2, f"CV_{name}"): name for name in names}
        self.numpy_type_to_cvtype = {dtype: depth for depth, dtype in DTYPES.items()}
        self.numpy_type_to_cvtype.update(DTYPES)

    # -- encodings

    def dtype_with_channels_to_cvtype2(self, dtype: Any, n_channels: int) -> str:
        """OpenCV's name of a type, for example '8UC3'."""
        depth = self.numpy_type_to_cvtype.get(np.dtype(dtype).name)
        if depth is None:
            raise CvBridgeError(
                f"An image of {np.dtype(dtype).name} has no encoding; convert it first, for example with "
                f"image.astype(numpy.uint8). Encodings exist for {', '.join(DTYPES.values())}."
            )
        return f"{depth}C{n_channels}"

    def cvtype2_to_dtype_with_channels(self, cvtype: int) -> tuple[str, int]:
        """(numpy's name of the type, channels) of OpenCV's number of a type."""
        depth, _, channels = self.cvtype_to_name[cvtype].partition("C")
        return DTYPES[depth], int(channels)

    def encoding_to_cvtype2(self, encoding: str) -> int:
        """OpenCV's number of an encoding's type; raises CvBridgeError for an unknown encoding."""
        return int(getattr(cv2, f"CV_{parsed_encoding(encoding).cv_type}"))

    def encoding_to_dtype_with_channels(self, encoding: str) -> tuple[str, int]:
        """(numpy's name of the type, channels) of an encoding; raises CvBridgeError for an unknown encoding."""
        parsed = parsed_encoding(encoding)
        return parsed.dtype, parsed.channels

    # -- messages to arrays

    def imgmsg_to_cv2(self, img_msg: Image, desired_encoding: str = "passthrough") -> Any:
        """The image of a message, unchanged (in the message's own memory) or converted; raises CvBridgeError."""
        encoding = parsed_encoding(img_msg.encoding)
        image = _pixels(img_msg, encoding)
        if img_msg.is_bigendian != (sys.byteorder == "big") and encoding.bits > 8:
            image = image.byteswap()
        if desired_encoding == "passthrough":
            return image
        return converted(image, img_msg.encoding, desired_encoding)

    def compressed_imgmsg_to_cv2(self, cmprs_img_msg: CompressedImage, desired_encoding: str = "passthrough") -> Any:
        """The image of a compressed message, as stored or converted from bgr8; raises CvBridgeError."""
        data = np.frombuffer(cmprs_img_msg.data, np.uint8)
        image = cv2.imdecode(data, cv2.IMREAD_UNCHANGED) if data.size else None
        if image is None:
            raise CvBridgeError(
                f"The {data.size} bytes of the message are no picture (format '{cmprs_img_msg.format}')."
            )
        if desired_encoding == "passthrough":
            return image
        return converted(image, "mono8" if image.ndim == 2 else "bgr8", desired_encoding)

    # -- arrays to messages

    def cv2_to_imgmsg(self, cvim: Any, encoding: str = "passthrough", header: Any = None) -> Image:
        """A message with a copy of the image; raises CvBridgeError if the array does not match the encoding."""
        _check_array(cvim)
        message = Image()
        if header is not None:
            message.header = header
        shape: tuple[int, ...] = cvim.shape
        message.height, message.width = shape[:2]
        cv_type = self.dtype_with_channels_to_cvtype2(cvim.dtype, 1 if len(shape) < 3 else shape[2])
        message.encoding = cv_type if encoding == "passthrough" else encoding
        if encoding != "passthrough" and parsed_encoding(encoding).cv_type != cv_type:
            raise CvBridgeError(f"encoding specified as {encoding}, but image has incompatible type {cv_type}")
        message.is_bigendian = int(cvim.dtype.byteorder == ">")
        data = array.array("B")
        data.frombytes(memoryview(np.ascontiguousarray(cvim).data).cast("B") if cvim.size else b"")
        message.data = data
        message.step = len(data) // message.height if message.height else 0
        return message

    def cv2_to_compressed_imgmsg(self, cvim: Any, dst_format: str = "jpg") -> CompressedImage:
        """A message with the image as a file: jpg, png, bmp, tiff, ...; raises CvBridgeError for other formats."""
        _check_array(cvim)
        try:
            done, data = cv2.imencode(f".{dst_format}", cvim)
        except cv2.error as error:
            raise CvBridgeError(f"OpenCV cannot write '{dst_format}': {error}") from None
        if not done:
            raise CvBridgeError(f"OpenCV cannot write '{dst_format}'. Use 'jpg' or 'png'.")
        return CompressedImage(format=dst_format, data=data.tobytes())


def _check_array(image: Any) -> None:
    if not isinstance(image, (np.ndarray, np.generic)):
        raise TypeError("Your input type is not a numpy array")


def parsed_encoding(encoding: str) -> Encoding:
    """The encoding with that name; raises CvBridgeError."""
    try:
        return parse(encoding)
    except UnknownEncoding as error:
        raise CvBridgeError(str(error)) from None


def converted(image: Any, source: str, target: str) -> Any:
    """A copy of `image`, converted from the encoding `source` to `target`; raises CvBridgeError."""
    try:
        return convert(image, source, target)
    except (ConversionError, UnknownEncoding) as error:
        raise CvBridgeError(str(error)) from None


def _pixels(msg: Image, encoding: Encoding) -> Any:
    """The message's bytes as an array, without the padding at the end of each row."""
    size = np.dtype(encoding.dtype).itemsize
    least = msg.width * size * encoding.channels
    if msg.step < least:
        raise CvBridgeError(
            f"Image is wrongly formed: step < width * byte_depth * num_channels  or  {msg.step} != "
            f"{msg.width} * {size} * {encoding.channels}"
        )
    if len(msg.data) < msg.height * msg.step:
        raise CvBridgeError(
            f"Image is wrongly formed: height * step != size  or  {msg.height} * {msg.step} != {len(msg.data)}"
        )
    rows = np.frombuffer(msg.data, np.uint8, msg.height * msg.step).reshape(msg.height, msg.step)
    image = np.ascontiguousarray(rows[:, :least]).view(encoding.dtype)
    shape = (msg.height, msg.width, encoding.channels)
    return image.reshape(shape[:2] if encoding.channels == 1 else shape)
