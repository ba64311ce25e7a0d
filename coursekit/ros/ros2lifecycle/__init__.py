"""`ros2 lifecycle` for programs and tests."""
