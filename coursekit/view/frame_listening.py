"""A buffer of frames that a node fills from /tf and /tf_static."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from coursekit.core.session import current
from coursekit.tf import FrameBuffer, Pose

Sample = tuple[str, str, int, Pose]
"""Parent, child, stamp [ns], and the child's pose in the parent."""
HEAR_SECONDS = 0.1
"""Frames that nobody asks for are heard so often, so that they do not pile up."""


class BroadcastFrames(FrameBuffer):
    """Frames as they are broadcast, and the broadcasters' time."""

    def __init__(self) -> None:
        super().__init__(report=lambda _level, _text: None)
        self.newest = self._arrived = 0
        self._unheard: list[tuple[Any, bool]] = []

    def hear(self, samples: list[Sample], fixed: bool, now_ns: int) -> None:
        """Take the samples of a message that came at this time [ns]."""
        if fixed:
            for parent, child, _, pose in samples:
                self.set_static(parent, child, pose)
            return
        self.extend(samples)
        for _, _, stamp, _ in samples:
            if stamp > self.newest:
                self.newest, self._arrived = stamp, now_ns

    def collect(self, subscription: Any, fixed: bool) -> None:
        """Let the messages of a subscription lie until `catch_up`: that is much cheaper than a callback for each."""
        core = subscription.handle.core
        core.attach(None, None)
        core.reduce = samples_of
        self._unheard.append((core, fixed))

    def catch_up(self) -> None:
        """Hear all that has come meanwhile."""
        for core, fixed in self._unheard:
            while core.queue and (entry := core.take()) is not None:
                kept = entry[0]  # a message, if it came before the subscription knew that samples are enough
                self.hear(kept if type(kept) is list else samples_of(kept), fixed, entry[1])

    def now(self, now_ns: int) -> int:
        """What time it is for who broadcasts [ns]: a simulator's clock need not be the session's."""
        return self.newest + now_ns - self._arrived if self.newest else now_ns


def samples_of(msg: Any) -> list[Sample]:
    """The transforms of a tf2_msgs/TFMessage."""
    return [_sample(transform) for transform in msg._transforms]


def _sample(transform: Any) -> Sample:
    """A geometry_msgs/TransformStamped as a sample."""
    header, motion = transform._header, transform._transform
    stamp, place, turn = header._stamp, motion._translation, motion._rotation
    return (
        header._frame_id,
        transform._child_frame_id,
        stamp._sec * 1_000_000_000 + stamp._nanosec,
        (place._x, place._y, place._z, turn._x, turn._y, turn._z, turn._w),
    )


def listen_to_frames(node: Any, heard: Callable[[], Any] | None = None) -> BroadcastFrames:
    """A buffer that follows what is broadcast; `heard()` is called after every message.

    Without `heard` it is up to date after `catch_up()`.
    """
    from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile
    from tf2_msgs.msg import TFMessage

    clock, buffer = current().clock, BroadcastFrames()
    for topic, fixed, durability in (
        ("/tf", False, DurabilityPolicy.VOLATILE),
        ("/tf_static", True, DurabilityPolicy.TRANSIENT_LOCAL),
    ):

        def take(msg: TFMessage, fixed: bool = fixed) -> None:
            buffer.hear(samples_of(msg), fixed, clock.now())
            if heard is not None:
                heard()

        qos = QoSProfile(history=HistoryPolicy.KEEP_ALL, durability=durability)
        subscription = node.create_subscription(TFMessage, topic, take, qos)
        if heard is None:
            buffer.collect(subscription, fixed)
    if heard is None:
        node.create_timer(HEAR_SECONDS, buffer.catch_up)
    return buffer


__all__ = ["BroadcastFrames", "listen_to_frames"]
