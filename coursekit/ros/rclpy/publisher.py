"""Publishers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from coursekit.interfaces import cdr
from rclpy._lent import lender
from rclpy._rclpy_pybind11 import Publisher as _Handle
from rclpy._rclpy_pybind11 import RCLError
from rclpy.duration import Duration

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.qos import QoSProfile

__getattr__ = lender(__name__)  # names that programs import from here


class Publisher:
    """A publisher, created by `Node.create_publisher`."""

    def __init__(
        self,
        publisher_impl: _Handle,
        msg_type: type[Any],
        topic: str,
        qos_profile: QoSProfile | int,
        event_callbacks: Any,
        callback_group: CallbackGroup,
    ) -> None:
        self.__publisher = publisher_impl
        self._core = publisher_impl.core
        self.msg_type = msg_type
        self.topic = topic
        self.qos_profile = qos_profile
        self.event_handlers = event_callbacks.create_event_handlers(
            callback_group, publisher_impl, topic
        )
        self._context_ok: Any = None

    def publish(self, msg: Any) -> None:
        """Send a copy of `msg`, which may also be a serialized message (bytes).

        >>> from geometry_msgs.msg import Twist
        >>> publisher = node.create_publisher(Twist, "cmd_vel", 10)
        >>> msg = Twist()
        >>> msg.linear.x = 0.2  # m/s
        >>> publisher.publish(msg)
        """
        if not self.__publisher.valid:
            self.__publisher.check()
        if not isinstance(msg, self.msg_type):
            if not isinstance(msg, bytes):
                raise TypeError(f"Expected {self.msg_type}, got {type(msg)}")
            msg = cdr.deserialize(msg, self.msg_type)
        if self._context_ok is not None and not self._context_ok():
            raise RCLError(
                "Failed to publish: publisher's context is invalid, at ./src/rcl/publisher.c:389"
            )
        self._core.publish(msg)

    def get_subscription_count(self) -> int:
        """The number of matched subscriptions.

        >>> from std_msgs.msg import String
        >>> publisher = node.create_publisher(String, "chatter", 10)
        >>> subscription = node.create_subscription(String, "chatter", print, 10)
        >>> publisher.get_subscription_count()
        1
        """
        with self.__publisher:
            return len(self._core.targets)

    @property
    def topic_name(self) -> str:
        """The resolved name."""
        with self.__publisher:
            return self._core.name

    @property
    def handle(self) -> _Handle:
        """The publisher's handle."""
        return self.__publisher

    @property
    def logger_name(self) -> str:
        """The name of its node's logger."""
        return self._core.node.logger_name

    def destroy(self) -> None:
        """Use `Node.destroy_publisher` instead."""
        for handler in self.event_handlers:
            handler.destroy()
        self.__publisher.destroy_when_not_in_use()

    def assert_liveliness(self) -> None:
        """Assert that the publisher is alive, for liveliness MANUAL_BY_TOPIC."""
        with self.__publisher:
            self._core.assert_liveliness()

    def wait_for_all_acked(self, timeout: Duration = Duration(seconds=-1)) -> bool:
        """Always True: a message is in the subscriptions' queues when `publish` returns.

        >>> from std_msgs.msg import String
        >>> publisher = node.create_publisher(String, "chatter", 10)
        >>> publisher.publish(String(data="hello"))
        >>> publisher.wait_for_all_acked()
        True
        """
        with self.__publisher:
            return True

    def __enter__(self) -> Publisher:
        return self

    def __exit__(self, *_error: object) -> None:
        self.destroy()
