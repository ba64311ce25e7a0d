"""A turtle's pose as a frame. In ROS 2: turtle_tf2_py.turtle_tf2_broadcaster."""

from coursekit.nodes.turtle_tf2.broadcasters import FramePublisher, quaternion_from_euler
from coursekit.nodes.turtle_tf2.broadcasters import turtle as main

__all__ = ["FramePublisher", "main", "quaternion_from_euler"]
