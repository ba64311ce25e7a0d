"""The severities of log messages. In ROS 2: rclpy.impl.logging_severity."""

from rclpy.impl.logging_state import LoggingSeverity

__all__ = ["LoggingSeverity"]
