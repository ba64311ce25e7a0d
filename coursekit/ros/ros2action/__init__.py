"""`ros2 action` for programs and tests."""
