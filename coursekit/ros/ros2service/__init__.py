"""`ros2 service` for programs and tests."""
