"""One transform that never changes. In ROS 2: turtle_tf2_py.static_turtle_tf2_broadcaster."""

from coursekit.nodes.turtle_tf2.broadcasters import StaticFramePublisher, quaternion_from_euler
from coursekit.nodes.turtle_tf2.broadcasters import static as main

__all__ = ["StaticFramePublisher", "main", "quaternion_from_euler"]
