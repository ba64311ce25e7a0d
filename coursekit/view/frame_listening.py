"""A buffer of frames that a node fills from /tf and /tf_static."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from coursekit.tf import FrameBuffer


def listen_to_frames(node: Any, heard: Callable[[], Any] | None = None) -> FrameBuffer:
    """A buffer that follows what is broadcast; `heard()` is called after every message."""
    from rclpy.qos import DurabilityPolicy, QoSProfile
    from tf2_msgs.msg import TFMessage
    from tf2_py._convert import nanoseconds, pose_of

    buffer = FrameBuffer(report=lambda _level, _text: None)

    def take(msg: TFMessage, fixed: bool) -> None:
        for transform in msg.transforms:
            pose = pose_of(transform.transform, ("", ""))
            stamp = 0 if fixed else nanoseconds(transform.header.stamp)
            buffer.set(transform.header.frame_id, transform.child_frame_id, stamp, pose, static=fixed)
        if heard is not None:
            heard()

    lasting = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    node.create_subscription(TFMessage, "/tf", lambda msg: take(msg, False), QoSProfile(depth=100))
    node.create_subscription(TFMessage, "/tf_static", lambda msg: take(msg, True), lasting)
    return buffer


__all__ = ["listen_to_frames"]
