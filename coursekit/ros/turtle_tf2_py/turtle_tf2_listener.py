"""A turtle that follows a frame. In ROS 2: turtle_tf2_py.turtle_tf2_listener."""

from coursekit.nodes.turtle_tf2.listener import FrameListener, main

__all__ = ["FrameListener", "main"]
