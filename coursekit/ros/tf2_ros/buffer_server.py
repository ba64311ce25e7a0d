"""A server that answers BufferClients from a buffer. In ROS 2: in C++ only."""

from __future__ import annotations

from typing import Any

from rclpy.action import ActionServer
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time
from tf2_msgs.action import LookupTransform
from tf2_msgs.msg import TF2Error
from tf2_py import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)

_CODES = (
    (ConnectivityException, TF2Error.CONNECTIVITY_ERROR),
    (LookupException, TF2Error.LOOKUP_ERROR),
    (ExtrapolationException, TF2Error.EXTRAPOLATION_ERROR),
    (InvalidArgumentException, TF2Error.INVALID_ARGUMENT_ERROR),
    (TimeoutException, TF2Error.TIMEOUT_ERROR),
    (TransformException, TF2Error.TRANSFORM_ERROR),
)


class BufferServer:
    """Serves the action `ns` of tf2_msgs/LookupTransform; retries goals that cannot be met yet every `check_period`."""

    def __init__(self, buffer: Any, node: Node, ns: str, check_period: Duration = Duration(seconds=0.01)) -> None:
        self.buffer = buffer
        self.node = node
        self._waiting: list[tuple[Any, int]] = []
        self.server = ActionServer(
            node, LookupTransform, ns, execute_callback=self._result, handle_accepted_callback=self._accepted
        )
        self.check_timer = node.create_timer(check_period.nanoseconds * 1e-9, self._check)

    def destroy(self) -> None:
        """Destroy the action server and the timer."""
        self.server.destroy()
        self.node.destroy_timer(self.check_timer)

    def _accepted(self, handle: Any) -> None:
        timeout = Duration.from_msg(handle.request.timeout).nanoseconds
        end = self.node.get_clock().now().nanoseconds + timeout
        if timeout <= 0 or self._can(handle.request):
            handle.execute()
        else:
            self._waiting.append((handle, end))

    def _check(self) -> None:
        if not self._waiting:
            return
        now = self.node.get_clock().now().nanoseconds
        waiting, self._waiting = self._waiting, []
        for handle, end in waiting:
            if now > end or self._can(handle.request):
                handle.execute()
            else:
                self._waiting.append((handle, end))

    def _can(self, goal: Any) -> bool:
        if goal.advanced:
            return bool(self.buffer.can_transform_full_core(*_advanced(goal))[0])
        return bool(self.buffer.can_transform_core(*_simple(goal))[0])

    def _result(self, handle: Any) -> Any:
        goal = handle.request
        result = LookupTransform.Result()
        try:
            if goal.advanced:
                result.transform = self.buffer.lookup_transform_full_core(*_advanced(goal))
            else:
                result.transform = self.buffer.lookup_transform_core(*_simple(goal))
        except TransformException as error:
            result.error.error = next(code for kind, code in _CODES if isinstance(error, kind))
            result.error.error_string = str(error)
        handle.succeed()  # a missing transform is a valid result, too
        return result


def _simple(goal: Any) -> tuple[str, str, Time]:
    return goal.target_frame, goal.source_frame, Time.from_msg(goal.source_time)


def _advanced(goal: Any) -> tuple[str, Time, str, Time, str]:
    target_time, source_time = Time.from_msg(goal.target_time), Time.from_msg(goal.source_time)
    return goal.target_frame, target_time, goal.source_frame, source_time, goal.fixed_frame
