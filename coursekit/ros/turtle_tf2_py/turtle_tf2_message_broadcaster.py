"""A turtle that publishes its positions as points. In ROS 2: turtle_tf2_py.turtle_tf2_message_broadcaster."""

from coursekit.nodes.turtle_tf2.messages import PointPublisher, main

__all__ = ["PointPublisher", "main"]
