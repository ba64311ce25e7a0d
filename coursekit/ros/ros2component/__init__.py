"""`ros2 component` for programs and tests."""
