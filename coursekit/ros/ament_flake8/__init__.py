"""Runs flake8 with ROS's settings."""
