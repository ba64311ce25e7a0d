"""BufferCore: the buffer of coursekit.tf with ROS's messages, under the names of the C++ binding."""

from __future__ import annotations

from typing import Any

from geometry_msgs.msg import TransformStamped
from rclpy.time import Time

from coursekit.tf import (
    DEFAULT_CACHE_NS,
    ConnectivityException,
    ExtrapolationException,
    FrameBuffer,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)
from coursekit.tf.velocity import velocity
from tf2_py._convert import nanoseconds, pose_of, stamped

_MEMBERS = ("transform.translation must have members x, y, z", "transform.rotation must have members w, x, y, z")
_TYPES = ("transform.translation must be of type Vector3", "transform.rotation must be of type Quaternion")


def _names(*frames: Any) -> None:
    for place, frame in enumerate(frames, start=1):
        if not isinstance(frame, str):
            raise TypeError(f"argument {place} must be str, not {type(frame).__name__}")


class BufferCore:
    """Transforms over time, kept for `cache_time` (ten seconds by default).

    >>> core = BufferCore()
    >>> core.can_transform_core("map", "robot", Time())
    (0, 'Invalid frame ID "map" passed to canTransform argument target_frame - frame does not exist')
    """

    def __init__(self, cache_time: Any = None) -> None:
        span = DEFAULT_CACHE_NS if cache_time is None else nanoseconds(cache_time, "duration")
        self._frames = FrameBuffer(span)

    def set_transform(self, transform: TransformStamped, authority: str) -> None:
        """Add a transform. If it is invalid, it is ignored and the reason is printed."""
        self._set(transform, authority)

    def set_transform_static(self, transform: TransformStamped, authority: str) -> None:
        """Add a transform that holds for all times."""
        self._set(transform, authority, True)

    def _set(self, transform: TransformStamped, authority: str, static: bool = False) -> bool:
        """Add a transform. Returns whether it was taken, as tf2's setTransform does in C++."""
        header = transform.header
        pose = pose_of(transform.transform, _TYPES if static else _MEMBERS)
        stamp = 0 if static else nanoseconds(header.stamp)
        return self._frames.set(header.frame_id, transform.child_frame_id, stamp, pose, authority, static=static)

    def lookup_transform_core(self, target_frame: str, source_frame: str, time: Any) -> TransformStamped:
        """The pose of `source_frame` in `target_frame` at a time; time 0 is the newest common time."""
        stamp = time._ns if type(time) is Time else nanoseconds(time)
        if type(target_frame) is not str or type(source_frame) is not str:
            _names(target_frame, source_frame)
        frames = self._frames
        with frames._lock:
            pose, stamp = frames.find(target_frame, source_frame, stamp)
        return stamped(target_frame, source_frame, stamp, pose)

    def lookup_transform_full_core(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> TransformStamped:
        """The pose of `source_frame` at its time in `target_frame` at its time, through `fixed_frame`."""
        _names(target_frame, source_frame, fixed_frame)
        pose, stamp = self._frames.lookup_full(
            target_frame, nanoseconds(target_time), source_frame, nanoseconds(source_time), fixed_frame
        )
        return stamped(target_frame, source_frame, stamp, pose)

    def can_transform_core(self, target_frame: str, source_frame: str, time: Any) -> tuple[int, str]:
        """(1, '') when the lookup would succeed, or 0 and the reason why not."""
        _names(target_frame, source_frame)
        can, why = self._frames.can(target_frame, source_frame, nanoseconds(time))
        return int(can), why

    def can_transform_full_core(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> tuple[int, str]:
        """(1, '') when the full lookup would succeed, or 0 and the reason why not."""
        _names(target_frame, source_frame, fixed_frame)
        can, why = self._frames.can_full(
            target_frame, nanoseconds(target_time), source_frame, nanoseconds(source_time), fixed_frame
        )
        return int(can), why

    def get_latest_common_time(self, target_frame: str, source_frame: str) -> Time:
        """The newest time at which a lookup succeeds."""
        _names(target_frame, source_frame)
        self._frames.require("get_latest_common_time", target_frame)
        self._frames.require("get_latest_common_time", source_frame)
        return Time(nanoseconds=self._frames.latest_common_time(target_frame, source_frame))

    def lookupVelocityCore(
        self, tracking_frame: str, observation_frame: str, time: Any, averaging_interval: Any
    ) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """Linear and angular velocity of `tracking_frame` relative to `observation_frame`."""
        return self.lookupVelocityFullCore(
            tracking_frame,
            observation_frame,
            observation_frame,
            (0.0, 0.0, 0.0),
            tracking_frame,
            time,
            averaging_interval,
        )

    def lookupVelocityFullCore(
        self,
        tracking_frame: str,
        observation_frame: str,
        reference_frame: str,
        reference_point: tuple[float, float, float],
        reference_point_frame: str,
        time: Any,
        averaging_interval: Any,
    ) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """The velocity at a reference point, expressed in `reference_frame`."""
        return velocity(
            self._frames,
            tracking_frame,
            observation_frame,
            reference_frame,
            reference_point,
            reference_point_frame,
            nanoseconds(time),
            nanoseconds(averaging_interval, "duration"),
        )

    def all_frames_as_yaml(self) -> str:
        """All frames with parent, broadcaster, rate and times."""
        return self._frames.all_frames_as_yaml()

    def all_frames_as_string(self) -> str:
        """A line for each frame that has a parent."""
        return self._frames.all_frames_as_string()

    def clear(self) -> None:
        """Discard all transforms."""
        self._frames.clear()

    def _frameExists(self, frame_id: str) -> bool:
        _names(frame_id)
        return frame_id in self._frames.frames

    def _getFrameStrings(self) -> list[str]:
        return list(self._frames.frames)

    def _allFramesAsDot(self, time: Any = None) -> str:
        return self._frames.all_frames_as_dot(0 if time is None else nanoseconds(time))

    def _chain(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> list[str]:
        return self._frames.chain(
            target_frame, nanoseconds(target_time), source_frame, nanoseconds(source_time), fixed_frame
        )


__all__ = [
    "BufferCore",
    "ConnectivityException",
    "ExtrapolationException",
    "InvalidArgumentException",
    "LookupException",
    "TimeoutException",
    "TransformException",
]
