"""`ros2 multicast` for programs and tests."""
