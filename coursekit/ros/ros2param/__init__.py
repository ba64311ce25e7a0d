"""`ros2 param` for programs and tests."""
