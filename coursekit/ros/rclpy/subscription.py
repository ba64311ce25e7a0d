"""Subscriptions."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from enum import Enum
from functools import partial
from typing import TYPE_CHECKING, Any

from rclpy._lent import lender
from rclpy._rclpy_info import as_bytes, message_info
from rclpy._rclpy_pybind11 import Subscription as _Handle

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.qos import QoSProfile

__getattr__ = lender(__name__)  # names that programs import from here


class Subscription:
    """A subscription, created by `Node.create_subscription`."""

    class CallbackType(Enum):
        """The kinds of callbacks, by their arguments."""

        MessageOnly = 0
        WithMessageInfo = 1

    def __init__(
        self,
        subscription_impl: _Handle,
        msg_type: type[Any],
        topic: str,
        callback: Callable[..., Any],
        callback_group: CallbackGroup,
        qos_profile: QoSProfile | int,
        raw: bool,
        event_callbacks: Any,
    ) -> None:
        self.__subscription = subscription_impl
        self._core = subscription_impl.core
        self._sources_list = [subscription_impl.core]
        self.msg_type = msg_type
        self.topic = topic
        self.callback = callback
        self.callback_group = callback_group
        self.qos_profile = qos_profile
        self.raw = raw
        self.event_handlers = event_callbacks.create_event_handlers(
            callback_group, subscription_impl, topic
        )

    @property
    def callback(self) -> Callable[..., Any]:
        """The function that is called with each message."""
        return self._callback

    @callback.setter
    def callback(self, value: Callable[..., Any]) -> None:
        self._callback = value
        self._callback_type = _callback_type(value)

    @property
    def handle(self) -> _Handle:
        """The subscription's handle."""
        return self.__subscription

    @property
    def topic_name(self) -> str:
        """The resolved name."""
        with self.__subscription:
            return self._core.name

    def get_publisher_count(self) -> int:
        """The number of matched publishers.

        >>> from std_msgs.msg import String
        >>> subscription = node.create_subscription(String, "chatter", print, 10)
        >>> subscription.get_publisher_count()
        0
        """
        with self.__subscription:
            return sum(self._core in publisher.targets for publisher in self._core.graph.publishers.get(self._core.name, ()))

    @property
    def logger_name(self) -> str:
        """The name of its node's logger."""
        return self._core.node.logger_name

    def destroy(self) -> None:
        """Use `Node.destroy_subscription` instead."""
        for handler in self.event_handlers:
            handler.destroy()
        self.__subscription.destroy_when_not_in_use()

    def _sources(self) -> list[Any]:
        return self._sources_list

    def _take(self) -> Any:
        entry = self._core.take() if self.__subscription.valid else None
        if entry is None:
            return None
        msg = as_bytes(entry[0]) if self.raw else entry[0]
        if self._callback_type is Subscription.CallbackType.MessageOnly:
            return partial(self._callback, msg)
        return partial(self._callback, msg, message_info(entry))

    def __enter__(self) -> Subscription:
        return self

    def __exit__(self, *_error: object) -> None:
        self.destroy()


def _callback_type(callback: Callable[..., Any]) -> Subscription.CallbackType:
    """Whether the callback also takes the message info, as in later ROS versions."""
    try:
        parameters = inspect.signature(callback).parameters.values()
    except (TypeError, ValueError):
        return Subscription.CallbackType.MessageOnly
    positional = (inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD)
    needed = [parameter for parameter in parameters if parameter.kind in positional and parameter.default is parameter.empty]
    if len(needed) >= 2:
        return Subscription.CallbackType.WithMessageInfo
    return Subscription.CallbackType.MessageOnly
