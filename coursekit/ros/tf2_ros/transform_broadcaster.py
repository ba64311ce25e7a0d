"""A broadcaster of changing transforms on /tf."""

from __future__ import annotations

from collections.abc import Iterable

from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from rclpy.qos import QoSProfile
from tf2_msgs.msg import TFMessage


class TransformBroadcaster:
    """A publisher of /tf."""

    def __init__(self, node: Node, qos: QoSProfile | int | None = None) -> None:
        self.pub_tf = node.create_publisher(TFMessage, "/tf", QoSProfile(depth=100) if qos is None else qos)

    def sendTransform(self, transform: TransformStamped | Iterable[TransformStamped]) -> None:
        """Send one transform, or several in one message.

        >>> from geometry_msgs.msg import TransformStamped
        >>> msg = TransformStamped()
        >>> msg.header.stamp = node.get_clock().now().to_msg()
        >>> msg.header.frame_id, msg.child_frame_id = "odom", "base_link"
        >>> TransformBroadcaster(node).sendTransform(msg)
        """
        self.pub_tf.publish(TFMessage(transforms=as_list(transform)))


def as_list(transform: TransformStamped | Iterable[TransformStamped]) -> list[TransformStamped]:
    """One transform or several as a list."""
    return list(transform) if hasattr(transform, "__iter__") else [transform]
