"""A listener that fills a buffer with broadcast transforms."""

from __future__ import annotations

from threading import Thread
from typing import Any

from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, ShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile
from tf2_msgs.msg import TFMessage

from coursekit.processes.session import current

DEFAULT_TF_TOPIC = "/tf"
DEFAULT_STATIC_TF_TOPIC = "/tf_static"


class TransformListener:
    """Subscribes to /tf and /tf_static for a buffer.

    With `spin_thread`, a thread of the listener's own spins the node. `static_only` leaves /tf out. If `node` is None,
    the listener creates a hidden node.

    >>> from geometry_msgs.msg import TransformStamped
    >>> from tf2_ros import Buffer, StaticTransformBroadcaster
    >>> buffer = Buffer()
    >>> listener = TransformListener(buffer, node)
    >>> msg = TransformStamped()
    >>> msg.header.frame_id, msg.child_frame_id = "base_link", "camera"
    >>> StaticTransformBroadcaster(node).sendTransform(msg)
    >>> rclpy.spin_once(node)
    >>> bool(buffer.can_transform("base_link", "camera", rclpy.time.Time()))
    True
    """

    def __init__(
        self,
        buffer: Any,
        node: Node | None,
        *,
        spin_thread: bool = False,
        qos: QoSProfile | int | None = None,
        static_qos: QoSProfile | int | None = None,
        tf_topic: str = DEFAULT_TF_TOPIC,
        tf_static_topic: str = DEFAULT_STATIC_TF_TOPIC,
        static_only: bool = False,
    ) -> None:
        self.buffer = buffer
        self.node = _own_node() if node is None else node
        self.group = ReentrantCallbackGroup()  # a callback of the node may thus wait for a transform
        if not static_only:
            self.tf_sub = self.node.create_subscription(
                TFMessage,
                tf_topic,
                self.callback,
                _keep(100, DurabilityPolicy.VOLATILE) if qos is None else qos,
                callback_group=self.group,
            )
        self.tf_static_sub = self.node.create_subscription(
            TFMessage,
            tf_static_topic,
            self.static_callback,
            _keep(100, DurabilityPolicy.TRANSIENT_LOCAL) if static_qos is None else static_qos,
            callback_group=self.group,
        )
        if spin_thread:
            self.executor = SingleThreadedExecutor(context=self.node.context)
            self.executor.add_node(self.node)
            self.dedicated_listener_thread = Thread(target=_spin, args=(self.executor,), daemon=True)
            self.dedicated_listener_thread.start()

    def __del__(self) -> None:
        if hasattr(self, "dedicated_listener_thread"):
            self.executor.shutdown(0)
        if hasattr(self, "tf_static_sub"):
            self.unregister()

    def unregister(self) -> None:
        """Destroy the subscriptions."""
        if hasattr(self, "tf_sub"):
            self.node.destroy_subscription(self.tf_sub)
        self.node.destroy_subscription(self.tf_static_sub)

    def callback(self, data: TFMessage) -> None:
        """Add transforms to the buffer."""
        for transform in data.transforms:
            self.buffer.set_transform(transform, "default_authority")

    def static_callback(self, data: TFMessage) -> None:
        """Add static transforms to the buffer."""
        for transform in data.transforms:
            self.buffer.set_transform_static(transform, "default_authority")


def _keep(depth: int, durability: DurabilityPolicy) -> QoSProfile:
    return QoSProfile(depth=depth, durability=durability, history=HistoryPolicy.KEEP_LAST)


def _own_node() -> Node:
    return Node(
        f"transform_listener_impl_{current().new_uuid().hex()[:10]}",
        enable_rosout=False,
        start_parameter_services=False,
        parameter_overrides=[Parameter("use_sim_time", value=False)],
    )


def _spin(executor: SingleThreadedExecutor) -> None:
    try:
        executor.spin()
    except (ExternalShutdownException, ShutdownException):
        pass
