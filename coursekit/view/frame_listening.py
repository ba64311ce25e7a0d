"""A buffer of frames that a node fills from /tf and /tf_static."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from coursekit.core.session import current
from coursekit.tf import FrameBuffer


class BroadcastFrames(FrameBuffer):
    """Frames as they are broadcast, and the broadcasters' time."""

    def __init__(self) -> None:
        super().__init__(report=lambda _level, _text: None)
        self.newest = self._arrived = 0

    def arrive(self, stamp: int, now_ns: int) -> None:
        """A transform of this stamp has come [ns]."""
        if stamp > self.newest:
            self.newest, self._arrived = stamp, now_ns

    def now(self, now_ns: int) -> int:
        """What time it is for who broadcasts [ns]: a simulator's clock need not be the session's."""
        return self.newest + now_ns - self._arrived if self.newest else now_ns


def listen_to_frames(node: Any, heard: Callable[[], Any] | None = None) -> BroadcastFrames:
    """A buffer that follows what is broadcast; `heard()` is called after every message."""
    from rclpy.qos import DurabilityPolicy, QoSProfile
    from tf2_msgs.msg import TFMessage
    from tf2_py._convert import nanoseconds, pose_of

    clock, buffer = current().clock, BroadcastFrames()

    def take(msg: TFMessage, fixed: bool) -> None:
        for transform in msg.transforms:
            pose = pose_of(transform.transform, ("", ""))
            stamp = 0 if fixed else nanoseconds(transform.header.stamp)
            buffer.set(transform.header.frame_id, transform.child_frame_id, stamp, pose, static=fixed)
            buffer.arrive(stamp, clock.now())
        if heard is not None:
            heard()

    lasting = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    node.create_subscription(TFMessage, "/tf", lambda msg: take(msg, False), QoSProfile(depth=100))
    node.create_subscription(TFMessage, "/tf_static", lambda msg: take(msg, True), lasting)
    return buffer


__all__ = ["BroadcastFrames", "listen_to_frames"]
