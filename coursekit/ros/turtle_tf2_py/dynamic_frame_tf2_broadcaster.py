"""A frame that circles turtle1. In ROS 2: turtle_tf2_py.dynamic_frame_tf2_broadcaster."""

from coursekit.nodes.turtle_tf2.broadcasters import DynamicFrameBroadcaster
from coursekit.nodes.turtle_tf2.broadcasters import dynamic as main

__all__ = ["DynamicFrameBroadcaster", "main"]
