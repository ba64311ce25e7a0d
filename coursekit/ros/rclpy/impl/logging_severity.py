"""How bad a log message is. In ROS 2: rclpy.impl.logging_severity."""

from rclpy.impl.logging_state import LoggingSeverity

__all__ = ["LoggingSeverity"]
