"""`ros2 topic` for programs and tests."""
