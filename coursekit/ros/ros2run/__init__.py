"""`ros2 run` for Python programs: `ros2run.api`."""
