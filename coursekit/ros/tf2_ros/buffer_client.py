"""A client that requests transforms from a BufferServer with an action."""

from __future__ import annotations

import warnings
from typing import Any

import builtin_interfaces.msg
from geometry_msgs.msg import TransformStamped
from rclpy.action.client import ActionClient
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

from coursekit.processes.session import current
from tf2_ros.buffer_interface import BufferInterface

_ERRORS = {
    TF2Error.LOOKUP_ERROR: LookupException,
    TF2Error.CONNECTIVITY_ERROR: ConnectivityException,
    TF2Error.EXTRAPOLATION_ERROR: ExtrapolationException,
    TF2Error.INVALID_ARGUMENT_ERROR: InvalidArgumentException,
    TF2Error.TIMEOUT_ERROR: TimeoutException,
}
GRACE_SECONDS = 2.0
"""The extra time for the result after the goal's timeout. Even without padding, the server's reason then arrives."""


class BufferClient(BufferInterface):
    """The buffer of another node, accessed with the action `ns`. Another thread must spin the node."""

    def __init__(
        self,
        node: Node,
        ns: str,
        check_frequency: float = 10.0,
        timeout_padding: Duration | float = Duration(seconds=2.0),
    ) -> None:
        super().__init__()
        self.node = node
        self.action_client = ActionClient(node, LookupTransform, action_name=ns)
        self.check_frequency = check_frequency
        self.timeout_padding = timeout_padding

    def destroy(self) -> None:
        """Destroy the action client."""
        self.action_client.destroy()

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Any, timeout: Duration = Duration()
    ) -> TransformStamped:
        """The transform from source to target; the server waits at most `timeout` for it."""
        if isinstance(time, builtin_interfaces.msg.Time):
            warnings.warn(
                "Passing a builtin_interfaces.msg.Time argument is deprecated, and will be removed in the near future. "
                "Use rclpy.time.Time instead.",
                stacklevel=2,
            )
            time = Time.from_msg(time)
        elif not isinstance(time, Time):
            raise TypeError("Must pass a rclpy.time.Time object.")
        goal = LookupTransform.Goal(target_frame=target_frame, source_frame=source_frame)
        goal.source_time = time.to_msg()
        goal.timeout = timeout.to_msg()
        return self._ask(goal, timeout)

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = Duration(),
    ) -> TransformStamped:
        """The pose of source at its time in target at its time."""
        goal = LookupTransform.Goal(target_frame=target_frame, source_frame=source_frame, fixed_frame=fixed_frame)
        goal.source_time = source_time.to_msg()
        goal.target_time = target_time.to_msg()
        goal.timeout = timeout.to_msg()
        goal.advanced = True
        return self._ask(goal, timeout)

    def can_transform(self, target_frame: str, source_frame: str, time: Time, timeout: Duration = Duration()) -> bool:
        """Whether the server has the transform."""
        try:
            self.lookup_transform(target_frame, source_frame, time, timeout)
            return True
        except TransformException:
            return False

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = Duration(),
    ) -> bool:
        """Whether the server can do the full lookup."""
        try:
            self.lookup_transform_full(target_frame, target_time, source_frame, source_time, fixed_frame, timeout)
            return True
        except TransformException:
            return False

    def _ask(self, goal: Any, timeout: Duration) -> TransformStamped:
        if not self.action_client.server_is_ready():
            raise TimeoutException("The BufferServer is not ready.")
        padding = self.timeout_padding
        patience = timeout.nanoseconds * 1e-9
        patience += padding.nanoseconds * 1e-9 if isinstance(padding, Duration) else padding
        sent = self.action_client.send_goal_async(goal)
        if not _wait(sent, patience):
            raise TimeoutException(
                "The LookupTransform goal sent to the BufferServer did not come back in the specified time. "
                "Something is likely wrong with the server."
            )
        handle = sent.result()
        if not handle.accepted:
            raise TimeoutException(
                "The LookupTransform goal sent to the BufferServer did not come back with accepted status. "
                "Something is likely wrong with the server."
            )
        result = handle.get_result_async()
        if not _wait(result, patience + GRACE_SECONDS):
            raise TimeoutException(
                "The LookupTransform goal sent to the BufferServer did not come back in the specified time. "
                "Something is likely wrong with the server."
            )
        return _checked(result.result().result)


def _wait(future: Any, seconds: float) -> bool:
    event = current().clock.new_event()
    future.add_done_callback(lambda _: event.set())
    return bool(future.done() or event.wait(seconds))


def _checked(result: Any) -> TransformStamped:
    error = result.error
    if error.error != TF2Error.NO_ERROR:
        raise _ERRORS.get(error.error, TransformException)(error.error_string)
    return result.transform
