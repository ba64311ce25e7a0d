"""`ros2 launch` for Python programs: `ros2launch.api`."""
