"""`ros2 interface` for programs and tests."""
