"""A buffer of frames that a node fills from /tf and /tf_static."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from coursekit.processes.session import current
from coursekit.tf import FrameBuffer, Sample

if TYPE_CHECKING:
    from rclpy.node import Node

Kept = tuple[str, str, int, int, float, float, float, float, float, float, float]
"""A transform: parent, child, stamp [s, ns], translation and quaternion."""
LOOK_SECONDS = 0.5
"""The period of clearing out unread messages, so that they do not pile up [s]."""


class BroadcastFrames(FrameBuffer):
    """Broadcast frames, and the time of their broadcasters."""

    def __init__(self) -> None:
        super().__init__(report=lambda _level, _text: None)
        self.newest = self._arrived = 0
        self._unheard: list[tuple[Any, bool]] = []
        self._outlived: dict[str, Kept] = {}
        self._outlived_at = 0

    def hear(self, kept: Iterable[Kept], fixed: bool, now_ns: int) -> None:
        """Add the transforms of a message that arrived at this time [ns]."""
        samples = _samples(kept)
        if fixed:
            for parent, child, _, pose in samples:
                self.set_static(parent, child, pose)
            return
        self._note(samples, now_ns)
        self.extend(samples)

    def _note(self, samples: Iterable[Sample], now_ns: int) -> None:
        newest = max([stamp for _, _, stamp, _ in samples], default=0)
        if newest > self.newest:
            self.newest, self._arrived = newest, now_ns

    def collect(self, subscription: Any, fixed: bool) -> None:
        """Leave the messages of a subscription in its queue until `catch_up`: much cheaper than a callback for each."""
        core = subscription.handle.core
        core.attach(None, None)
        core.reduce = numbers_of
        self._unheard.append((core, fixed))

    def catch_up(self) -> None:
        """Process all queued messages."""
        outlived, self._outlived = self._outlived, {}
        self.hear(outlived.values(), False, self._outlived_at)
        for core, fixed in self._unheard:
            moving: list[Sample] = []
            while core.queue and (entry := core.take()) is not None:
                if fixed:
                    self.hear(_kept_in(entry), fixed, entry[1])
                else:
                    samples = _samples(_kept_in(entry))
                    self._note(samples, entry[1])
                    moving += samples
            self.extend(moving)

    def thin_out(self, now_ns: int) -> None:
        """Drop queued messages older than the buffer's reach, but keep the last transform of each frame."""
        limit, outlived = now_ns - self.cache_ns, self._outlived
        for core in [core for core, fixed in self._unheard if not fixed]:
            lying = core.queue
            while lying and lying[0][1] < limit and (entry := core.take()) is not None:
                self._outlived_at = entry[1]
                for kept in _kept_in(entry):
                    outlived[kept[1]] = kept

    def now(self, now_ns: int) -> int:
        """Return the broadcasters' time [ns]: a simulator's clock may differ from the session's."""
        return self.newest + now_ns - self._arrived if self.newest else now_ns


def _kept_in(entry: Any) -> list[Kept]:
    """Return the numbers of a queue entry: messages that arrived before `reduce` was set are still whole."""
    kept = entry[0]
    return kept if type(kept) is list else numbers_of(kept)


def numbers_of(msg: Any) -> list[Kept]:
    """Extract the transforms of a tf2_msgs/TFMessage; done for each message, while the rest is done on demand."""
    return [
        (
            header._frame_id, transform._child_frame_id, header._stamp._sec, header._stamp._nanosec,
            place._x, place._y, place._z, turn._x, turn._y, turn._z, turn._w,
        )
        for transform in msg._transforms
        for header, place, turn in [(transform._header, transform._transform._translation, transform._transform._rotation)]
    ]  # fmt: skip


def _samples(kept: Iterable[Kept]) -> list[Sample]:
    return [
        (parent, child, sec * 1_000_000_000 + nanosec, (x, y, z, i, j, k, w))
        for parent, child, sec, nanosec, x, y, z, i, j, k, w in kept
    ]


def listen_to_frames(node: Node, heard: Callable[[], Any] | None = None) -> BroadcastFrames:
    """Return a buffer that follows the broadcast frames; `heard()` is called after every message.

    Without `heard`, the buffer is up to date after `catch_up()`. The node must already be in its executor in this case.
    """
    from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile
    from tf2_msgs.msg import TFMessage

    clock, buffer = current().clock, BroadcastFrames()
    for topic, fixed, durability in (
        ("/tf", False, DurabilityPolicy.VOLATILE),
        ("/tf_static", True, DurabilityPolicy.TRANSIENT_LOCAL),
    ):

        def take(msg: TFMessage, fixed: bool = fixed) -> None:
            buffer.hear(numbers_of(msg), fixed, clock.now())
            if heard is not None:
                heard()

        qos = QoSProfile(history=HistoryPolicy.KEEP_ALL, durability=durability)
        subscription = node.create_subscription(TFMessage, topic, take, qos)
        if heard is None:
            buffer.collect(subscription, fixed)
    if heard is None:
        node.create_timer(LOOK_SECONDS, lambda: buffer.thin_out(clock.now()))
    return buffer


__all__ = ["BroadcastFrames", "listen_to_frames"]
