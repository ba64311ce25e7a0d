"""`ros2 bag` for programs and tests."""
