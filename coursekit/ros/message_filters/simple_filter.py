"""The base class of filters, and the first filter of a chain: a subscription."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any

import rclpy
from rclpy.clock import ROSClock
from rclpy.logging import LoggingSeverity
from rclpy.time import Time


class SimpleFilter:
    """Passes messages on to callbacks."""

    def __init__(self) -> None:
        self.callbacks: dict[int, tuple[Callable[..., Any], tuple[Any, ...]]] = {}
        self._numbers = itertools.count()

    def registerCallback(self, cb: Callable[..., Any], *args: Any) -> int:
        """Call `cb(*messages, *args)` for each output; return the number of the connection."""
        connection = next(self._numbers)
        self.callbacks[connection] = (cb, args)
        return connection

    def unregisterCallback(self, conn: int) -> None:
        """End the connection of this number, if there is one."""
        self.callbacks.pop(conn, None)

    def signalMessage(self, *msg: Any) -> None:
        """Pass messages on."""
        for callback, args in list(self.callbacks.values()):
            callback(*msg, *args)


class Subscriber(SimpleFilter):
    """A subscription as a filter: Subscriber(node, msg_type, topic, ...), as for create_subscription.

    >>> from std_msgs.msg import String
    >>> chatter = Subscriber(node, String, "chatter")
    >>> connection = chatter.registerCallback(lambda msg: print(msg.data))
    >>> node.create_publisher(String, "chatter", 10).publish(String(data="hello"))
    >>> rclpy.spin_once(node)
    hello
    """

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__()
        self.node, self.topic = args[0], args[2]
        if len(args) < 4:
            kwargs.setdefault("qos_profile", 10)
        self.sub = self.node.create_subscription(*args[1:3], self.callback, *args[3:], **kwargs)

    def callback(self, msg: Any) -> None:
        """Pass a received message on."""
        self.signalMessage(msg)

    def getTopic(self) -> str:
        """The topic, as given."""
        return str(self.topic)

    def __getattr__(self, key: str) -> Any:
        if key == "sub":  # not created yet
            raise AttributeError(key)
        return getattr(self.sub, key)


def stamp_of(msg: Any, allow_headerless: bool, logger: str, what: str) -> Time | None:
    """A message's time: its header's, or now if that is allowed; None (and a warning) otherwise."""
    if hasattr(msg, "header") and hasattr(msg.header, "stamp"):
        return time_of(msg.header.stamp)
    if allow_headerless:
        return ROSClock().now()
    log = rclpy.logging.get_logger(logger)
    log.set_level(LoggingSeverity.INFO)
    log.warning(
        f"can not use message filters {what}messages without timestamp infomation when 'allow_headerless' is disabled. "
        "auto assign ROSTIME to headerless messages once enabling constructor option of 'allow_headerless'."
    )
    return None


def time_of(stamp: Any) -> Time:
    """Return a stamp as Time. It may be rclpy's Time, a message, or a plain number of nanoseconds."""
    if isinstance(stamp, int):
        return Time(nanoseconds=stamp)
    return stamp if hasattr(stamp, "nanoseconds") else Time.from_msg(stamp)
