"""A broadcaster of static transforms on /tf_static, which late listeners still receive."""

from __future__ import annotations

from collections.abc import Iterable

from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile
from tf2_msgs.msg import TFMessage

from tf2_ros.transform_broadcaster import as_list


class StaticTransformBroadcaster:
    """A publisher of /tf_static. Each message contains all transforms so far, because only the last message is kept."""

    def __init__(self, node: Node, qos: QoSProfile | int | None = None) -> None:
        if qos is None:
            qos = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL, history=HistoryPolicy.KEEP_LAST)
        self.pub_tf = node.create_publisher(TFMessage, "/tf_static", qos)
        self.net_message = TFMessage()

    def sendTransform(self, transform: TransformStamped | Iterable[TransformStamped]) -> None:
        """Send one transform, or several; a transform of a known child replaces the old one.

        >>> from geometry_msgs.msg import TransformStamped
        >>> msg = TransformStamped()
        >>> msg.header.frame_id, msg.child_frame_id = "base_link", "camera"
        >>> StaticTransformBroadcaster(node).sendTransform(msg)
        """
        known = {sent.child_frame_id: sent for sent in self.net_message.transforms}
        known.update((new.child_frame_id, new) for new in as_list(transform))
        self.net_message.transforms = list(known.values())
        self.pub_tf.publish(self.net_message)
