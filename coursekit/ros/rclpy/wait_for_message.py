"""Wait for one message on a topic."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy._lent import lender
from rclpy.executors import SingleThreadedExecutor
from rclpy.task import Future

if TYPE_CHECKING:
    from rclpy.node import Node
    from rclpy.qos import QoSProfile

__getattr__ = lender(__name__)  # names that programs import from here


def wait_for_message(
    msg_type: type[Any], node: Node, topic: str, time_to_wait: float | int = -1, *, qos_profile: QoSProfile | int = 1
) -> tuple[bool, Any]:
    """(True, message) for the next message on `topic`; (False, None) after `time_to_wait` seconds (-1: no limit).

    >>> from std_msgs.msg import String
    >>> from rclpy.wait_for_message import wait_for_message
    >>> wait_for_message(String, node, "/chatter", time_to_wait=1.0)  # nobody publishes
    (False, None)
    """
    received = Future()

    def receive(msg: Any) -> None:
        if not received.done():
            received.set_result(msg)

    subscription = node.create_subscription(msg_type, topic, receive, qos_profile)
    executor = SingleThreadedExecutor(context=node.context)  # separate from the executor that the node may have
    executor._attach(subscription)
    try:
        executor.spin_until_future_complete(received, None if time_to_wait < 0 else time_to_wait)
    finally:
        node.destroy_subscription(subscription)
    return (True, received.result()) if received.done() else (False, None)
