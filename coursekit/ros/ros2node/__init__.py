"""`ros2 node` for programs and tests."""
