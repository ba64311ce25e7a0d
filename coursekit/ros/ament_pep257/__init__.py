"""Runs pydocstyle with ROS's settings."""
