"""Interfaces of robot_localization."""
