"""Frames in time: tf2's algorithms, without ROS. Poses are plain tuples, stamps are integer nanoseconds.

>>> from coursekit.tf import FrameBuffer
>>> buffer = FrameBuffer()
>>> buffer.set_static("base", "laser", (0.1, 0.0, 0.2, 0.0, 0.0, 0.0, 1.0))
True
>>> buffer.lookup("base", "laser").pose[:3]
(0.1, 0.0, 0.2)

In ROS 2: tf2::BufferCore.
"""

from coursekit.geometry.pose import IDENTITY, Pose, compose, interpolate, inverse, rotate, slerp

from .buffer import FrameBuffer, Lookup
from .errors import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)
from .store import DEFAULT_CACHE_NS, Sample

__all__ = [
    "DEFAULT_CACHE_NS",
    "IDENTITY",
    "ConnectivityException",
    "ExtrapolationException",
    "FrameBuffer",
    "InvalidArgumentException",
    "Lookup",
    "LookupException",
    "Pose",
    "Sample",
    "TimeoutException",
    "TransformException",
    "compose",
    "interpolate",
    "inverse",
    "rotate",
    "slerp",
]
