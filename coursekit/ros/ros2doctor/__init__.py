"""`ros2 doctor` for programs and tests."""
