"""An executor that passes the source time of messages to subscription callbacks, even with Humble's rclpy."""

from __future__ import annotations

from typing import Any

from rclpy.exceptions import InvalidHandle
from rclpy.executors import MultiThreadedExecutor, await_or_execute
from rclpy.subscription import Subscription


class HumblesExecutor(MultiThreadedExecutor):
    """Passes to callbacks, as a second argument, the message info that rclpy up to Humble takes and drops."""

    def _take_subscription(self, sub: Any) -> Any:
        try:
            with sub.handle:
                return sub.handle.take_message(sub.msg_type, sub.raw)
        except InvalidHandle:  # the subscription has just been destroyed
            return None

    async def _execute_subscription(self, sub: Any, taken: Any) -> None:
        if taken:
            await await_or_execute(sub.callback, *taken)


InformingExecutor = MultiThreadedExecutor if hasattr(Subscription, "CallbackType") else HumblesExecutor
"""Newer releases pass the message info to each callback with two parameters."""
