"""A frame that stays beside turtle1. In ROS 2: turtle_tf2_py.fixed_frame_tf2_broadcaster."""

from coursekit.nodes.turtle_tf2.broadcasters import FixedFrameBroadcaster
from coursekit.nodes.turtle_tf2.broadcasters import fixed as main

__all__ = ["FixedFrameBroadcaster", "main"]
