"""The module in which ROS's own rclpy keeps its C module; programs import `rclpy_implementation` from here."""

from rclpy import _rclpy_pybind11 as rclpy_implementation

__all__ = ["rclpy_implementation"]
