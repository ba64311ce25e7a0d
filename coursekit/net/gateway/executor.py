"""An executor whose subscriptions are told when a message was sent, also with Humble's rclpy."""

from __future__ import annotations

from typing import Any

from rclpy.exceptions import InvalidHandle
from rclpy.executors import MultiThreadedExecutor, await_or_execute
from rclpy.subscription import Subscription


class HumblesExecutor(MultiThreadedExecutor):
    """Gives callbacks what rclpy takes and drops up to Humble: the message's information, as a second argument."""

    def _take_subscription(self, sub: Any) -> Any:
        try:
            with sub.handle:
                return sub.handle.take_message(sub.msg_type, sub.raw)
        except InvalidHandle:  # it has just been destroyed
            return None

    async def _execute_subscription(self, sub: Any, taken: Any) -> None:
        if taken:
            await await_or_execute(sub.callback, *taken)


InformingExecutor = MultiThreadedExecutor if hasattr(Subscription, "CallbackType") else HumblesExecutor
"""Newer releases inform each callback that has two parameters."""
