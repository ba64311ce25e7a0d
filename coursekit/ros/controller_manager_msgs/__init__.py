"""Interfaces: controllers and hardware of ros2_control."""
