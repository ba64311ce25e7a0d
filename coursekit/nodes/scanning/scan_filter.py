"""A queue of scans that wait for their transform, like tf2_ros's MessageFilter; dropped scans are logged with the reason."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Any

from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from rclpy.time import Time
from sensor_msgs.msg import LaserScan
from tf2_ros import Buffer

FULL = "discarding message because the queue is full"
EARLY = "the timestamp on the message is earlier than all the data in the transform cache"
EMPTY_FRAME = "the frame id of the message is empty"
QUIET_NS = 1_000_000_000
"""The minimum time between two logs of the same reason [ns]."""


class WakingBuffer(Buffer):
    """A buffer that calls back after every transform."""

    def call_after_each(self, callback: Callable[[], None]) -> None:
        """Call `callback()` after every transform, in addition to earlier callbacks."""
        self._new_data_callbacks.append(callback)


class ScanFilter:
    """Passes scans on, in order, once `buffer` can transform them to `target`; at most `size` scans wait."""

    def __init__(
        self, node: Node, buffer: WakingBuffer, target: str, size: int, callback: Callable[[LaserScan], None]
    ) -> None:
        self._node, self._buffer, self._target, self._size = node, buffer, target, max(size, 1)
        self._callback = callback
        self._waiting: deque[LaserScan] = deque()
        self._told: dict[str, int] = {}
        buffer.call_after_each(self.try_waiting)

    def add(self, scan: LaserScan) -> None:
        """Add a scan."""
        if not scan.header.frame_id:
            self._drop(scan, EMPTY_FRAME)
            return
        self.try_waiting()
        if len(self._waiting) >= self._size:
            self._drop(self._waiting.popleft(), FULL)
        self._waiting.append(scan)
        self.try_waiting()

    def clear(self) -> bool:
        """Discard the waiting scans. Return whether there were any."""
        some = bool(self._waiting)
        self._waiting.clear()
        return some

    def try_waiting(self) -> None:
        """Pass on the scans that can be transformed now."""
        while self._waiting:
            scan = self._waiting[0]
            ready, why = self._ask(scan)
            if ready:
                self._waiting.popleft()
                self._callback(scan)
            elif "extrapolation into the past" in why:
                self._drop(self._waiting.popleft(), EARLY)
            else:
                return

    def _ask(self, scan: LaserScan) -> tuple[bool, str]:
        """Whether a scan's transform is known, and the reason if it is not."""
        stamp = Time.from_msg(scan.header.stamp, self._node.get_clock().clock_type)
        ready, why = self._buffer.can_transform_core(self._target, scan.header.frame_id, stamp)
        return bool(ready), why

    def _drop(self, scan: LaserScan, reason: str) -> None:
        """Log that a scan was dropped, and which transform is missing."""
        frame = scan.header.frame_id
        at = scan.header.stamp.sec + scan.header.stamp.nanosec * 1e-9
        why = self._ask(scan)[1] if frame else "set header.frame_id in the node that publishes the scan"
        if self._quiet(f"{frame}:{reason}"):
            return
        log = self._node.get_logger()
        log.info(f"Message Filter dropping message: frame '{frame}' at time {at:.3f} for reason '{reason}'")
        log.warning(f"{self._missing(frame, why)}")

    def _missing(self, frame: str, why: str) -> str:
        """A text with the missing transform, and the command that shows it."""
        if not frame:
            return why
        return (
            f"No transform '{self._target}' -> '{frame}' for this scan: {why or 'not yet'}. "
            f"Try: ros2 run tf2_ros tf2_echo {self._target} {frame}"
        )

    def _quiet(self, key: str) -> bool:
        """Whether this was logged less than QUIET_NS ago; otherwise record it."""
        now = self._node.get_clock().now().nanoseconds
        if key in self._told and 0 <= now - self._told[key] < QUIET_NS:
            return True
        self._told[key] = now
        return False


def lookup(buffer: Any, target: str, source: str, stamp: Any) -> TransformStamped:
    """A transform at a message's stamp; raises TransformException."""
    transform: TransformStamped = buffer.lookup_transform_core(target, source, Time.from_msg(stamp))
    return transform
