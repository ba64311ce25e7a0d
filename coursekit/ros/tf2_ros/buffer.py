"""The buffer that programs use: it waits for transforms and serves `tf2_frames`."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.clock import Clock, ClockChange, ClockType, JumpThreshold, TimeJump
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.task import Future
from rclpy.time import Time
from tf2_msgs.srv import FrameGraph
from tf2_py import BufferCore
from tf2_py._convert import nanoseconds

from coursekit.processes.session import current
from tf2_ros.buffer_interface import BufferInterface

_AT_ONCE = Duration()
POLL_SECONDS = 0.02
"""The period at which a wait polls a clock that follows /clock."""


class Buffer(BufferCore, BufferInterface):
    """Transforms of the last `cache_time`, filled by a TransformListener.

    With a `node` it offers the service tf2_frames and waits on the node's clock. It is cleared when the clock jumps back.
    """

    def __init__(self, cache_time: Duration | None = None, node: Node | None = None) -> None:
        BufferCore.__init__(self, cache_time)
        BufferInterface.__init__(self)
        self._new_data_callbacks: list[Callable[[], None]] = []
        self._clock: Any = Clock() if node is None else node.get_clock()
        if node is not None:
            self.srv = node.create_service(FrameGraph, "tf2_frames", self._get_frames)
            back = JumpThreshold(min_forward=None, min_backward=Duration(seconds=-1), on_clock_change=True)
            self.jump_handle = self._clock.create_jump_callback(back, post_callback=self._jumped)

    def _get_frames(self, _request: Any, response: Any) -> Any:
        response.frame_yaml = self.all_frames_as_yaml()
        return response

    def _jumped(self, jump: TimeJump) -> None:
        same = jump.clock_change is ClockChange.ROS_TIME_NO_CHANGE
        what = "jump back in time" if same else "time source change"
        rclpy.logging.get_logger("tf2_buffer").warning(f"Detected {what}. Clearing TF buffer.")
        self.clear()

    def _set(self, transform: TransformStamped, authority: str, static: bool = False) -> bool:
        """Add a transform, and wake pending waits."""
        taken = super()._set(transform, authority, static)
        if self._new_data_callbacks:
            self._call_new_data_callbacks()
        return taken

    def _call_new_data_callbacks(self) -> None:
        for callback in list(self._new_data_callbacks):
            callback()

    def _remove_callback(self, callback: Callable[[], None]) -> None:
        if callback in self._new_data_callbacks:
            self._new_data_callbacks.remove(callback)

    # -- lookups

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Time, timeout: Duration = _AT_ONCE
    ) -> TransformStamped:
        """The transform from source to target; waits at most `timeout` until it is available.

        `time` Time() is the newest. Raises LookupException, ConnectivityException, ExtrapolationException,
        InvalidArgumentException.

        >>> from geometry_msgs.msg import TransformStamped
        >>> camera = TransformStamped()
        >>> camera.header.frame_id, camera.child_frame_id = "base_link", "camera"
        >>> camera.transform.translation.x = 0.1  # m
        >>> buffer = Buffer()
        >>> buffer.set_transform_static(camera, "example")
        >>> buffer.lookup_transform("base_link", "camera", rclpy.time.Time()).transform.translation.x
        0.1
        """
        if timeout is not _AT_ONCE and timeout != _AT_ONCE:
            self._wait(lambda: self.can_transform_core(target_frame, source_frame, time)[0], timeout)
        return self.lookup_transform_core(target_frame, source_frame, time)

    async def lookup_transform_async(self, target_frame: str, source_frame: str, time: Time) -> TransformStamped:
        """The transform from source to target, as soon as it is available."""
        await self.wait_for_transform_async(target_frame, source_frame, time)
        return self.lookup_transform_core(target_frame, source_frame, time)

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = _AT_ONCE,
    ) -> TransformStamped:
        """The pose of source at its time in target at its time; `fixed_frame` did not move in between."""
        asked = (target_frame, target_time, source_frame, source_time, fixed_frame)
        if timeout is not _AT_ONCE and timeout != _AT_ONCE:
            self._wait(lambda: self.can_transform_full_core(*asked)[0], timeout)
        return self.lookup_transform_full_core(*asked)

    async def lookup_transform_full_async(
        self, target_frame: str, target_time: Time, source_frame: str, source_time: Time, fixed_frame: str
    ) -> TransformStamped:
        """The same, as soon as it is available."""
        asked = (target_frame, target_time, source_frame, source_time, fixed_frame)
        await self.wait_for_transform_full_async(*asked)
        return self.lookup_transform_full_core(*asked)

    # -- queries

    def can_transform(
        self,
        target_frame: str,
        source_frame: str,
        time: Time,
        timeout: Duration = _AT_ONCE,
        return_debug_tuple: bool = False,
    ) -> Any:
        """Whether the lookup would succeed within `timeout`; with `return_debug_tuple` also the reason why not.

        >>> bool(Buffer().can_transform("map", "base_link", rclpy.time.Time()))
        False
        """
        return self._can(lambda: self.can_transform_core(target_frame, source_frame, time), timeout, return_debug_tuple)

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = _AT_ONCE,
        return_debug_tuple: bool = False,
    ) -> Any:
        """Whether the full lookup would succeed within `timeout`."""
        asked = (target_frame, target_time, source_frame, source_time, fixed_frame)
        return self._can(lambda: self.can_transform_full_core(*asked), timeout, return_debug_tuple)

    def _can(self, ask: Callable[[], tuple[int, str]], timeout: Duration, debug: bool) -> Any:
        if timeout is not _AT_ONCE and timeout != _AT_ONCE:
            self._wait(lambda: ask()[0], timeout)
        answer = ask()
        return answer if debug else answer[0]

    def _wait(self, ready: Callable[[], Any], timeout: Any) -> None:
        """Wait until ready, until the timeout, or until the clock jumps back by more than three seconds."""
        if ready():
            return
        clock = self._clock
        start = clock.now().nanoseconds
        end = start + nanoseconds(timeout, "timeout")
        follows = clock.clock_type == ClockType.ROS_TIME and clock.ros_time_is_active
        news = current().clock.new_event()
        self._new_data_callbacks.append(news.set)
        try:
            while start - 3_000_000_000 <= (now := clock.now().nanoseconds) < end and not ready():
                left = (end - now) * 1e-9
                news.wait(min(left, POLL_SECONDS) if follows else left)
                news.clear()
        finally:
            self._remove_callback(news.set)

    # -- futures

    def wait_for_transform_async(self, target_frame: str, source_frame: str, time: Time) -> Future:
        """A future that completes with True once the lookup would succeed."""
        return self._when(lambda: self.can_transform_core(target_frame, source_frame, time)[0])

    def wait_for_transform_full_async(
        self, target_frame: str, target_time: Time, source_frame: str, source_time: Time, fixed_frame: str
    ) -> Future:
        """A future that completes with True once the full lookup would succeed."""
        asked = (target_frame, target_time, source_frame, source_time, fixed_frame)
        return self._when(lambda: self.can_transform_full_core(*asked)[0])

    def _when(self, ready: Callable[[], Any]) -> Future:
        future = Future()
        if ready():
            future.set_result(True)
            return future

        def look() -> None:
            try:
                if not future.done() and ready():
                    future.set_result(True)
            except BaseException as error:
                future.set_exception(error)

        self._new_data_callbacks.append(look)
        future.add_done_callback(lambda _: self._remove_callback(look))
        return future
